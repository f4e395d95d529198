//! Loads that repeat: what is held when it is put on once may walk out when it is put on a thousand times.
//!
//! The scenes are those of `examples/scenes/repeat`, and the commands are typed there. Loads are put on and taken off again in turn, beside what is there at rest, cycle after
//! cycle; what is told holds for all time, see [`shake`](crate::shake). A program of legs, turns among them, is a cycle too if it leads back to where it begins:
//! in a scene `legs` in place of `loads`.
//!
//! | it | and that means |
//! |---|---|
//! | rests | after some cycles nothing slides any more |
//! | comes to rest | slips become ever smaller; how much the object moves in all is told |
//! | slides to and fro | contacts rub in every cycle and wear; the object stays |
//! | walks | the object moves on by as much in every cycle |
//! | is lost | in the cycle that is told |
//!
//! # A block stands on a shaking tray that leans. Does it stay?
//!
//! ```text
//! $ grasp-lcp shake block.json
//! WALKS: the object moves 0.01 mm along +x in every cycle, left foot and right foot slide. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! 3.5 N pull at a block of 10 N with a friction of 0.5: put on once, 5 N would be held. But the block leans on one foot and then on the other, 3 N and 7 N. What the foot that carries less cannot hold the other one
//! takes over: in every cycle it walks by `2 (Q - μ (P - 2 m)) / k = 2 (3.5 - 0.5 (10 - 4)) / 10⁵` metres. Up to 3 N it rests.
//!
//! # A hammer jerks along its handle. Does it creep out of the hand?
//!
//! ```text
//! $ grasp-lcp shake tool.json
//! RESTS after a cycle: until then index slides; in all the object turns 0.700577° anticlockwise about (-0.00321429, -0.0220179) m
//! ```
//!
//! The first blow of 35 N shifts it a little, and then friction locks it: no later blow moves it on. With 45 N a finger rubs:
//!
//! ```text
//! $ grasp-lcp shake tool.json --base 0,-5.886 --at=-0.05,0 --force 45,0 --force=-45,0
//! SLIDES TO AND FRO: index slides by up to 3.49266 mm in every cycle, which takes 0.0230909 J; the object stays. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! # A milling cutter pushes one way and the other. Does the part creep out of its fixture?
//!
//! ```text
//! $ grasp-lcp shake fixture.json
//! SLIDES TO AND FRO: lower left slides by up to 0.0180734 mm in every cycle, which takes 0.000513745 J; the object stays. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! It does not, but the locator is worn: 0.5 mJ a tooth.
//!
//! # Does a parcel survive being shaken with 2 g?
//!
//! Its mass and the size of the acceleration are enough: it pulls to and fro along every axis in turn.
//!
//! ```text
//! $ grasp-lcp shake ../box.json --mass 0.2 --acceleration 19.6
//! RESTS: nothing ever slides
//! ```
//!
//! `grasp-lcp draw fixture.json` draws how far each contact has slipped cycle by cycle, and the loop of friction against slip that remains: what it encloses is the heat.
//!
//! # How hard must it press, to be shaken for ever?
//!
//! [`Need::to_rest`](crate::need::Need::to_rest) seeks the least squeeze or friction, or the greatest load, with which it comes to rest; on the command line `--repeats`, in a scene `"demand": "rests"`. With
//! `--may-slide` beside it (`"stays"`) the object only must not walk. The hammer:
//!
//! ```text
//! $ grasp-lcp need tool.json squeeze --base 0,-5.886 --at=-0.05,0 --force 35,0 --repeats
//! NEEDS 40.4707 N at palm, 13.4902 N at index, 13.4902 N at middle and 13.4902 N at little (0.674512 times the squeeze given) so that it comes to rest however often the load is put on, 1.14799 times as much if friction is 10 % less and the squeeze is 5 % less. With less: SLIDES TO AND FRO: index slides by up to 4.70665e-8 mm in every cycle, which takes 1.66189e-10 J; the object stays. Good for slow shaking: inertia acts only as far as the loads contain it
//! ```
//!
//! # Could it come to rest at all?
//!
//! [`Statics::shakedown`](crate::ask::Statics::shakedown) bounds it from above without following anything: with more than so many times the loads the grasp never comes to rest, in
//! whichever order they come. Where slips do not change what contacts press with, it does come to rest with less; elsewhere the order decides. In a scene the question is `shakedown`.
//!
//! ```text
//! $ grasp-lcp shake ../box.json --mass 0.2 --acceleration 19.6 --any-order
//! RESTS in whichever order they come, up to 1.54031 times these loads. With more, right slides
//! ```
//!
//! A roller that is rocked to and fro under a shear rests up to `1 - 3 w / 2 + w³ / 2` of what friction holds, w the rocking over half the width of its contact; a test of the repository
//! approaches that with 81 springs.
