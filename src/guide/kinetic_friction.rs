//! Friction that is lower once a contact slides: is the object caught, or does it fall at the first slip?
//!
//! Most tables have two coefficients. A scene has the second one as `kinetic_friction` in addition to `friction`, Rust as
//! [`kinetic`](crate::grasp::Contact::kinetic). Without a second coefficient a contact slides with the same friction as it sticks with.
//!
//! # A box on a plastic foot and a rubber foot is pulled
//!
//! ```text
//! $ grasp-lcp hold feet.json
//! HOLDS, but plastic foot slides from 0.9375 of it on, caught after slipping 0.6 mm at plastic foot, counting no momentum; lost at 13 N (1.625 times this load)
//! ```
//!
//! Both feet press with 10 N. The plastic one is twice as stiff: of 7.5 N it carries 5 N, its limit. It slides, keeps 4 N, and the rubber foot takes
//! over the difference. If both feet had the coefficients of plastic, the box would be held exactly if the softer foot is at most `μ_k/μ_s` times as
//! stiff as the other. With equal stiffness both slide at once, and the box is lost.
//!
//! ```text
//! $ grasp-lcp hold feet.json --base 0,-20 --force 14,0
//! SLIPS OUT at 13 N of 14 N beside the load at rest, caught at 7.5 N after slipping 0.6 mm at plastic foot, counting no momentum, after which it takes 12 N: the object moves along +x, plastic foot and rubber foot slide (gross slip)
//! ```
//!
//! If no other contact takes over the force, the sentence says *falls at the first slip*. The load after *it takes* (12 N here) is the load that the
//! grasp holds with kinetic friction from the start.
//!
//! # Contents of the answer
//!
//! Contacts that begin to slide lose the force `(μ_s - μ_k) F_n` at once. Other contacts take over this force at the same load; a contact that
//! reaches its static limit in this process begins to slide, too. In the end either all forces balance again, or the object is lost.
//! [`Event::jump`](crate::load_path::Event::jump) has this jump: the equilibrium after it, the slips of the contacts and the energy lost.
//! [`Loss::jumped`](crate::load_path::Loss::jumped) has the contacts that slipped before the object was lost. A contact that continues to slide as
//! the load grows keeps its kinetic friction. A contact regains its static friction when it sticks, when the load reverses, and during a pause. A
//! pause is a leg (section) of a load program along which nothing changes.
//!
//! Under a load that repeats ([`shake`](crate::ask::Grasp::shake)) contacts may jump again and again. The motion may repeat only after several
//! cycles; the answer then says, for example, *in every 4 cycles*. Slips and motions are then given for all of these cycles together. For 255 random
//! grasps (`GRASP_LCP_SAMPLES=15 cargo test --test shake what_jumps`) 254 verdicts agree with cycles followed one by one. One is undecided: its
//! forces still change after 1000 cycles.
//!
//! The first slip is the same with and without kinetic friction, because it depends on static friction alone. The same holds for all questions about
//! sticking contacts: the load at first slip, also in screening and with uncertain data, and force closure.
//!
//! # Limitations
//!
//! * **No overshoot.** *Counting no momentum*, the object comes to rest where forces balance, as if it moved in oil. If a slider is pulled by a
//!   spring, the spring force falls at first slip from `μ_s N` to `μ_k N`, and the slider then slides steadily. Without damping the spring force
//!   falls twice as far, to `(2 μ_k - μ_s) N`. The slider then sticks, and all this repeats: stick-slip. In such a jump the change of force at other
//!   contacts is up to about twice the computed change. Contacts that catch the object in the computation may then fail to do so. `2 μ_k - μ_s` in
//!   place of `μ_k` shows this effect; for one spring it is exact.
//! * **The path of a jump.** If several contacts join in, or one sticks again on the way, the damping may decide. The tests move 400 random planar
//!   grasps through a viscous medium: all were caught or lost as computed, and 14 came to rest elsewhere.
//! * **Another equilibrium.** If a jump is not caught, [`LoadPath::beyond`](crate::load_path::Path::beyond) says whether an equilibrium exists with
//!   the remaining friction. It is not known whether the object arrives at this equilibrium; the object therefore counts as lost.
//! * **Alternating stick and slip.** Contacts that slide together may push each other back: each jump of one contact lets another contact stick. The
//!   smaller the difference of the two coefficients, the smaller and more numerous these jumps are. A leg has at most
//!   [`Settings::most_steps`](crate::Settings::most_steps) of them.
//! * **Soft fingertips** slide point after point, and each point hands its lost force to the others. The load at which they are lost converges with
//!   the number of points. For μ_k/μ_s = 0.7, ten points in a row hold 5 % more than the limit of many points, forty 1.2 % more.
//! * **Speed and age.** Both coefficients are constants. Friction that grows with the time at rest, or falls with the speed, is not included.
//!
//! # Skin and rubber: friction that falls with force
//!
//! For `μ(N) = μ₁ N^(n-1)` ask twice, with the coefficients at the least and at the largest normal force of the contact under the load. The two
//! answers are bounds if more friction is better. Skin loses about half of its coefficient from 1 N to 20 N.
