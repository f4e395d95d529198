//! Friction that is lower once a contact slides: is the object caught, or does it fall at the first slip?
//!
//! Most tables give two coefficients. A scene says the second one as `kinetic_friction` beside `friction`, Rust as
//! [`kinetic`](crate::grasp::Contact::kinetic). Left out, a contact slides with the friction that it has at rest.
//!
//! # A box is pulled that stands on a plastic foot and a rubber foot
//!
//! ```text
//! $ grasp-lcp hold feet.json
//! HOLDS, but plastic foot slides from 0.9375 of it on, caught after slipping 0.6 mm at plastic foot; lost at 1.625 times this load
//! ```
//!
//! Both feet press with 10 N. The plastic one is twice as stiff: of 7.5 N it carries 5 N, all that it can. It slides, keeps 4 N, and the rubber foot takes over what it loses. Both
//! with the coefficients of plastic would be held if and only if the softer foot is at most `μ_k/μ_s` times as stiff as the other one. As stiff as each other they slide at once, and the box is gone.
//!
//! ```text
//! $ grasp-lcp hold feet.json --base 0,-20 --force 14,0
//! SLIPS OUT at 13 N of 14 N beside the load at rest, caught at 7.5 N after slipping 0.6 mm at plastic foot, after which it takes 12 N: the object moves along +x, plastic foot and rubber foot slide (gross slip)
//! ```
//!
//! Where nothing catches it the sentence says *falls at the first slip*. What it takes after that is the load that friction of sliding holds from the beginning.
//!
//! # What is told
//!
//! Contacts that begin to slide lose `(μ_s - μ_k) F_n` at once. What they lose goes over to the others at the same load; who reaches its friction of rest on that way begins to slide, too. At the end everything is in
//! balance again, or nothing holds: [`Event::jump`](crate::load_path::Event::jump) has the state after, who slipped how far and the energy that is lost; [`Loss::jumped`](crate::load_path::Loss::jumped) who
//! slipped before the object was lost. What goes on sliding as the load grows keeps its friction of sliding. What comes to rest has that of rest again: where it sticks, where the load turns back, and on a leg along
//! which nothing changes, a pause.
//!
//! A load that repeats ([`shake`](crate::ask::Grasp::shake)) makes contacts jump again and again. It may take several cycles until everything repeats, *in every 4 cycles*; amounts are those of all of them together. Of 800 random
//! grasps (`SHAKEN=200 cargo test --test shake what_jumps`) 798 verdicts are those of cycles that are followed, and two are undecided: one repeats itself after 88 cycles, and is not yet near that after 1000.
//!
//! The first slip is the same with and without: it is a matter of rest. So are all questions that know rest alone, such as onsets, screening, reserves and statics.
//!
//! # What it misses
//!
//! * **It does not shoot over.** The object comes to rest where forces balance, as in oil. A slider on a spring falls from `μ_s N` to `μ_k N` and then slides steadily. One without damping falls twice as far,
//!   to `(2 μ_k - μ_s) N`, sticks, and does so again: stick-slip. In such a jump others take up to about twice the change that is told here, and some that would catch do not.
//!   `2 μ_k - μ_s` in place of `μ_k` shows what that would do; for one spring it is exact.
//! * **Which way it goes.** Where several contacts join, or one sticks again on the way, the damping may decide. Of 400 random planar grasps the tests move through something viscous all were caught or lost as told here, and 14 came
//!   to rest elsewhere.
//! * **Another equilibrium.** Where a jump is not caught, [`LoadPath::beyond`](crate::load_path::Path::beyond) says whether anything holds with the friction that is left. Whether the object arrives there is not known here: it is told as lost.
//! * **Stick and slip in turn.** Contacts that slide together may push each other back: each jump of one lets another one stick. The less friction falls the smaller and the more these jumps are, up to
//!   [`Settings::most_steps`](crate::Settings::most_steps) a leg.
//! * **Soft fingertips** slide point after point, and each point leaves to the others what it loses. The load at which they are lost converges as there are more of them: with r = 0.7 ten points in a row
//!   hold 5 % more than so many that it no longer matters, forty 1.2 %.
//! * **Speed and age.** Both coefficients are numbers. Friction that grows with the time at rest, or falls with the speed, is not in them.
//!
//! # Skin and rubber: friction that falls with force
//!
//! For `μ(N) = μ₁ N^(n-1)` ask twice, with the coefficients at the least and at the largest normal force that the contact has under the load. The answers bracket it where more friction is
//! better. Skin loses about half of its coefficient from 1 N to 20 N.
