//! Loads that repeat: a load that is held when applied once may make the object walk out when applied a thousand times.
//!
//! The scenes are in `examples/scenes/repeat`, and the commands are run there. Loads are applied and removed in turn, in addition to the load at rest
//! (the constant base load), cycle after cycle. The verdict holds for any number of cycles, see [`shake`](crate::shake). A load program of several
//! legs (sections) is a cycle, too, if it returns to its start. A leg may also turn the load. A scene then has `legs` in place of `loads`.
//!
//! | verdict | meaning |
//! |---|---|
//! | rests | after some cycles no contact slides any more |
//! | comes to rest | slips become ever smaller; the answer has the total motion of the object |
//! | slides to and fro | contacts rub in every cycle and wear; the object stays |
//! | walks | the object moves by the same amount in every cycle |
//! | is lost | the object is lost in the cycle that the answer names |
//!
//! # A block stands on a shaking tray that leans. Does it stay?
//!
//! ```text
//! $ grasp-lcp shake block.json
//! WALKS: the object moves 0.01 mm along +x in every cycle, left foot and right foot slide. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! A pull of Q = 3.5 N acts on a block of weight P = 10 N with a coefficient of friction μ = 0.5. Applied once, a pull of 5 N would be held. But
//! rocking moves m = 2 N from one foot to the other: one presses with 3 N, the other with 7 N. The foot that presses harder takes over the friction
//! that the other foot cannot hold. With the stiffness k = 10⁵ N/m of a foot the block walks in every cycle by
//! `2 (Q - μ (P - 2 m)) / k = 2 (3.5 - 0.5 (10 - 4)) / 10⁵` metres. Up to a pull of 3 N the block comes to rest.
//!
//! # A hammer jerks along its handle. Does it creep out of the hand?
//!
//! ```text
//! $ grasp-lcp shake tool.json
//! RESTS after a cycle: until then index slides; in all the object turns 0.700577° anticlockwise about (-0.00321429, -0.0220179) m
//! ```
//!
//! The first blow of 35 N shifts the hammer a little, and then friction locks it: no later blow moves it further. With 45 N a finger rubs:
//!
//! ```text
//! $ grasp-lcp shake tool.json --base 0,-5.886 --at=-0.05,0 --force 45,0 --force=-45,0
//! GOES TOO FAR: index slips by more than 2.5 mm: results for small motions no longer apply. Otherwise SLIDES TO AND FRO: index slides by up to 3.49266 mm in every cycle, which takes 0.0230909 J; the object stays. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! # A milling cutter pushes one way and the other. Does the part creep out of its fixture?
//!
//! ```text
//! $ grasp-lcp shake fixture.json
//! SLIDES TO AND FRO: lower left slides by up to 0.0180734 mm in every cycle, which takes 0.000513745 J; the object stays. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! The part does not creep out, but the locator wears: friction takes 0.5 mJ in every cycle, that is, with every tooth of the cutter.
//!
//! # Does a parcel survive being shaken with 2 g?
//!
//! The command needs only the mass and the magnitude of the acceleration, which acts to and fro along every axis in turn.
//!
//! ```text
//! $ grasp-lcp shake ../box.json --mass 0.2 --acceleration 19.6
//! RESTS: nothing slides as the load repeats
//! ```
//!
//! `grasp-lcp draw fixture.json` draws the slip of each contact over the cycles, and the final loop of friction against slip, whose area is the heat.
//!
//! # How hard must it press to survive any number of cycles?
//!
//! [`Need::to_rest`](crate::need::Need::to_rest) seeks the least squeeze or friction, or the greatest load, with which the object comes to rest; on
//! the command line `--repeats`, in a scene `"demand": "rests"`. With `--may-slide` in addition (`"stays"`) contacts may slide in every cycle, but
//! the object must not walk. For the hammer:
//!
//! ```text
//! $ grasp-lcp need tool.json squeeze --base 0,-5.886 --at=-0.05,0 --force 35,0 --repeats
//! NEEDS 41.0639 N at palm, 13.688 N at index, 13.688 N at middle and 13.688 N at little (0.684399 times the squeeze given), at most 3.65061 times the squeeze given, so that it comes to rest however often the load is put on
//!   if friction is 10 % less and the squeeze is 5 % less: 1.16794 times as much
//!   with less: GOES TOO FAR in a cycle: palm slips by more than 2.5 mm: results for small motions no longer apply
//!   with more than 219.036 N at palm, 73.0122 N at index, 73.0122 N at middle and 73.0122 N at little (3.65061 times the squeeze given): GOES TOO FAR in a cycle: it turns by more than 5.7°: results for small motions no longer apply
//!   tried were 18 amounts from 0.05 to 10 times the squeeze given
//! ```
//!
//! # Could it come to rest at all?
//!
//! [`Statics::shakedown`](crate::ask::Statics::shakedown) gives an upper bound without following cycles, the shakedown factor. With loads multiplied
//! by more than this factor the grasp never comes to rest, whatever the order of the loads. With smaller loads the grasp comes to rest if slips do
//! not change the normal forces; otherwise the order of the loads decides whether it does. In a scene the question is `shakedown`.
//!
//! ```text
//! $ grasp-lcp shake ../box.json --mass 0.2 --acceleration 19.6 --any-order
//! RESTS in whichever order they come, up to 1.54031 times these loads. With more, right slides
//! ```
//!
//! A roller that is rocked back and forth under a shear force rests if this force is at most `1 - 3 w / 2 + w³ / 2` times the friction limit. Here w
//! is the distance by which the contact pressure moves to either side, divided by half the width of the contact. A test of the repository approaches
//! this limit with 81 springs.
