//! Choosing fingers: where they should be, and how hard they should press, so that the first slip comes as late as possible, or most friction is left.
//!
//! The scenes are those of `examples/scenes/improve`, and the commands are typed there. A contact that may move has a `surface`, on which it lies;
//! its normal follows. `at_most` (or `--at-most`) says how many newtons fingers may press with; without it they press as they are commanded. Loads
//! grow in proportion, one at a time, or it is a force of any direction.
//!
//! # Two jaws hold a box whose weight hangs aside. Where should they be?
//!
//! ```text
//! $ grasp-lcp improve pinch.json
//! FIRST SLIP at 10 N instead of 6 N: left moves 5 mm along its edge and right 5 mm along its edge; both press with 9.64286 N. Nothing nearby is better to first order, as left and right leave first, within the greatest command of left and the greatest command of right
//! ```
//!
//! Level with each other the jaw that is nearer to the weight would slide first. One of them higher by `2 μ e`, with the weight e = 10 mm aside, the
//! couple of the normal forces balances that: both carry half, and `2 μ N` is all that their friction can do. `grasp-lcp draw pinch.json` draws the
//! grasp before and after.
//!
//! # Three fingers hold a disc. Where should they be against a force of any direction?
//!
//! ```text
//! $ grasp-lcp improve disc.json
//! FIRST SLIP at 13.4164 N instead of 10.8291 N: index moves 5.99153 mm along its circle and middle 5.99153 mm along its circle; all press with 10 N. Nothing nearby is better to first order, as thumb and middle leave first, within the greatest force of thumb, the greatest force of index and the greatest force of middle
//! ```
//!
//! At thirds, wherever the first of them is: the force that slides first is `3 N sin α`, with α the angle of friction.
//!
//! # A can is lifted and jerked aside
//!
//! ```text
//! $ grasp-lcp improve can.json
//! FIRST SLIP at 5.75043 times the loads instead of 2.70146 times the loads: thumb moves 23.942 mm along its cylinder, index 27.681 mm along its cylinder and middle 21.7256 mm along its cylinder; thumb presses with 14.9927 N, index with 14.9927 N and middle with 15 N. Nothing nearby is better to first order, as thumb, index and middle leave first, within the greatest force of middle, the greatest command of thumb and the greatest command of index
//! ```
//!
//! # The load is known. Where is most left of their friction?
//!
//! A first slip that comes late is for a load that may become larger than it is known to be. Where the load is known, and what is not are
//! disturbances beside it, `--reserve` (`"goal": "reserve"` in scenes) asks for the friction that is left while it acts in full:
//! the [margin](crate::equilibrium::ContactAnswer::margin) of the contact that has least, N.
//!
//! ```text
//! $ grasp-lcp improve pinch.json --force 0,-4 --at 0.01,0 --at-most 10 --reserve
//! RESERVE of 3 N instead of 1.33333 N: left moves 2 mm along its edge and right 2 mm along its edge; both press with 9.94109 N. Nothing nearby is better to first order, as left and right have least, within the greatest command of left and the greatest command of right
//! ```
//!
//! Both carry half again, and keep `μ N - W / 2`; but one jaw is higher by `W e / N`, 4 mm, where the couple balances the weight as it is. With the 10 mm of the
//! first question the weight of 4 N alone would turn the box, and the jaws would carry unequal parts of it.
//!
//! # What the answer promises
//!
//! "Nothing nearby is better to first order" is a proof by multipliers: gradients of what slides first, and of bounds that are met, cancel up to a
//! millionth. [`Improved::residual`](crate::improve::Improved::residual) says up to what. So no small step gains in proportion to its length.
//! It is no proof that nothing far away is better: several starts are scattered over the surfaces for that, as many as `starts` says, and the best
//! answer is told. Each thing that stands in the way has its multiplier ([`InTheWay`](crate::improve::InTheWay)): how much later the first slip would
//! come, or how much more would be left, for one more newton of force, or one more metre of edge.
//!
//! In space two point contacts have to lie on one line with the load, and no other place balances it: the search says so. With three fingers, or
//! four, it is free to move. From an edge of a polyline, or a triangle of a mesh, fingers go over to the next where that gains; normals jump there, so that
//! the proof is for the ones that they stand on in the end. Loads that turn, hands with joints, several bodies, vacuums and soft fingertips that move are refused by name.
