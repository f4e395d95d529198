//! Choosing fingers: places and clamping forces for which first slip comes as late as possible, or most friction is left.
//!
//! The scenes are in `examples/scenes/improve`, and the commands are run there. A contact that may move has a `surface`, on which it lies and which
//! determines the normal. `at_most` (or `--at-most`) is the largest force in newtons that fingers may press with; without it fingers keep their
//! commands. The loads of a question grow from zero, one at a time. A question may also have a force of given magnitude in any direction, which grows
//! from zero, too.
//!
//! # Two jaws hold a box whose weight hangs aside. Where should they be?
//!
//! ```text
//! $ grasp-lcp improve pinch.json
//! FIRST SLIP at 10 N instead of 6 N: left moves 5 mm along its edge and right 5 mm along its edge; both `pressed_with` 10 N (at rest 9.64286 N). Nothing nearby is better to first order, as left and right leave first, within the greatest command of left and the greatest command of right
//! ```
//!
//! If the jaws were level, the jaw nearer to the weight would slide first. With the weight e = 10 mm aside and one jaw higher by `2 μ e`, the couple
//! of the normal forces N balances the moment of the weight. Each jaw then carries half of the weight, up to a weight of `2 μ N`, at which the
//! friction of both jaws is used up. `grasp-lcp draw pinch.json` draws the grasp before and after.
//!
//! `pressed_with` 10 N is given in the scene: the force of a jaw on an object that is held in place. The object gives way to the jaws, so that at
//! rest they press with less.
//!
//! # Three fingers hold a disc. Where should they be against a force of any direction?
//!
//! ```text
//! $ grasp-lcp improve disc.json
//! FIRST SLIP at 13.4164 N instead of 10.8291 N: index moves 5.99153 mm along its circle and middle 5.99153 mm along its circle; all `pressed_with` 10 N. Nothing nearby is better to first order, as thumb, index and middle leave first, within the greatest force of thumb, the greatest force of index and the greatest force of middle
//! ```
//!
//! The optimum has the fingers at thirds of the circle, wherever the first finger is. The least force under which a finger slides is `3 N sin α`,
//! with the friction angle α.
//!
//! # A can is lifted and jerked aside
//!
//! ```text
//! $ grasp-lcp improve can.json
//! FIRST SLIP at 5.75043 times the loads instead of 2.70146 times the loads: thumb moves 23.942 mm along its cylinder, index 27.681 mm along its cylinder and middle 21.7256 mm along its cylinder; thumb `pressed_with` 15 N (at rest 14.9927 N), index 15 N (at rest 14.9927 N) and middle 14.9861 N (at rest 15 N). Nothing nearby is better to first order, as thumb, index and middle leave first, within the greatest force of middle, the greatest command of thumb and the greatest command of index
//! ```
//!
//! # The load is known. Where is most friction left?
//!
//! Late first slip is the goal for a load that may become larger than expected. If the load is known but disturbances are not, `--reserve`
//! (`"goal": "reserve"` in scenes) maximises the least [margin](crate::equilibrium::ContactAnswer::margin) of all contacts under the full load. The
//! margin is the additional friction force, N, that a contact could take before it slides.
//!
//! ```text
//! $ grasp-lcp improve pinch.json --force 0,-4 --at 0.01,0 --at-most 10 --reserve
//! RESERVE of 3 N instead of 1.33333 N: left moves 2 mm along its edge and right 2 mm along its edge; both `pressed_with` 10 N (at rest 9.94109 N). Nothing nearby is better to first order, as left and right have least, within the greatest command of left and the greatest command of right
//! ```
//!
//! Each jaw again carries half of the weight W, and keeps a margin of `μ N - W / 2`, where N is the normal force. Here one jaw is higher by `W e /
//! N`, 4 mm, so that the couple balances the weight of 4 N. With the difference in height of 10 mm, the answer to the first question, this weight
//! would turn the box, and the jaws would carry unequal parts of it.
//!
//! # Guarantees of the answer
//!
//! "Nothing nearby is better to first order" is proved by multipliers. The load factor at which a contact slides has a gradient, and so has each
//! bound on places and forces. The sum of the gradients of the contacts that slide first and of the active bounds, weighted with these multipliers,
//! is zero up to a millionth. [`Improved::residual`](crate::improve::Improved::residual) is what remains of this sum. No small move of the fingers
//! therefore gains in proportion to its length. Distant places may still be better. The search therefore starts from several places (`starts`) on the
//! surfaces and returns the best answer. Each contact that slides first and each active bound has a multiplier
//! ([`ActiveConstraint`](crate::improve::ActiveConstraint)). The multiplier of a bound is the gain in load factor or margin for one more newton of
//! force, or one more metre of edge.
//!
//! In space two point contacts balance no moment about the line that joins them. They hold a load only if it has no such moment, which a move of one
//! contact would change: they cannot move, and the answer says so. Three or four fingers can move. From an edge of a polyline, or a triangle of a
//! mesh, fingers cross to the next one if that is a gain. Normals jump between them. The proof therefore holds only for the edges or triangles on
//! which the fingers end. Turning loads, hands with joints, several bodies, vacuums and movable soft fingertips are refused with an error that names
//! them.
