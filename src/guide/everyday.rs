//! Twelve everyday questions in plain words, each answered by one command.
//!
//! The scenes are in `examples/scenes/everyday`, each at most 12 lines long, and the commands are run there. The first line of the output is the
//! answer, which is quoted here; further lines give details. `grasp-lcp new` writes six of these scenes as a starting point.
//!
//! # My gripper presses with 20 N on a box of half a kilogram. Does it hold while the arm starts upwards with 5 m/s²?
//!
//! ```text
//! $ grasp-lcp hold gripper.json --mass 0.5 --acceleration 0,0,5
//! HOLDS, everything sticks: 24 N (3.24105 times this load) until it is lost, as left jaw and right jaw slide
//! ```
//!
//! Friction of the two jaws holds up to 2 · 0.6 · 20 N = 24 N. The box pulls with 0.5 · (9.81 + 5) = 7.4 N.
//!
//! An arm that swings also throws the box outwards: `--angular-velocity 0,0,90`, in degrees per second, `--about` a point of the axis, with
//! `--angular-acceleration` and the `--inertia` of the box; see [`Payload`](crate::grasp::Payload).
//!
//! # I push a box on a table with 8 N. Does it slide or tip over?
//!
//! ```text
//! $ grasp-lcp hold box_on_table.json
//! TIPS OVER at 6.53333 N of 8 N beside the load at rest: the object tips over about right edge, left edge opens
//! ```
//!
//! The *load at rest* is the weight of 19.6 N (`base` in the scene), which stays constant while the push grows. About the right edge the weight has
//! an arm of 50 mm and the push an arm of 150 mm: the box tips at 19.6 · 50 / 150 = 6.53 N. Sliding would take 0.4 · 19.6 = 7.84 N.
//!
//! # Which friction does a wedge of 15 degrees need to stay in its gap?
//!
//! ```text
//! $ grasp-lcp need wedge.json
//! NEEDS a coefficient of friction of 0.131653 so that it holds and nothing slides
//!   if friction is 10 % less: 0.146281
//!   with less: GOES TOO FAR at rest already: it turns by more than 5.7°; beyond this, results for small motions no longer apply
//!   tried were 14 amounts from 0.009 to 0.5
//! ```
//!
//! The value is the tangent of half the angle of the wedge, tan 7.5°, however hard the wedge is driven in. Here and below, 5.7° is 0.1 rad: at larger
//! turns the model, which assumes small motions, no longer applies ([`SmallMotions`](crate::SmallMotions)).
//!
//! # Does a suction cup of 40 mm hold a plate of 2 kg that is pulled sideways with 10 N?
//!
//! ```text
//! $ grasp-lcp hold suction.json
//! HOLDS, everything sticks: 37.2115 N (1.68978 times this load) until the first slip (cup), 41.6218 N (1.89005 times) until cup slips by more than 2 mm
//! ```
//!
//! A vacuum of 60 kPa on 1257 mm² pulls with 75.4 N. The first slip is at the point of the lip where pull, shear and peel add up; see
//! [`suction_cups`](super::suction_cups).
//!
//! # How far may I climb on a ladder?
//!
//! ```text
//! $ grasp-lcp need ladder.json
//! TAKES an arm of 1.98101 m and holds, and something slides, opens or gives way with every amount that was tried
//!   with more: TURNS OUT at once, under any part of 950 N: the object turns about (0, 4.532) m
//! ```
//!
//! The arm is the horizontal distance of the climber from the foot of the ladder: 4.69 m along the ladder of 5 m. With the climber at this height
//! both friction at the foot and friction at the wall are used up. With smaller arms one of the two contacts slides a little, and the other holds the
//! ladder.
//!
//! # How hard do the clamps of my fixture have to press, whichever way the cutter pushes?
//!
//! ```text
//! $ grasp-lcp need fixture.json
//! NEEDS 152.233 N at upper clamp and 95.1455 N at side clamp (0.190291 times the squeeze given) so that it holds, 0.534873 times the squeeze given so that nothing slides
//!   if friction is 10 % less and the squeeze is 5 % less: 1.09928 times as much
//!   with less: under a force along (-0.292867, 0.956153): TURNS OUT at 100 N of 100 N: the object turns about (-0.03, 0) m, lower left, side, upper clamp and side clamp slide (gross slip)
//! ```
//!
//! # How hard do three fingers have to press to carry a full mug of 400 g?
//!
//! ```text
//! $ grasp-lcp need mug.json squeeze --mass 0.4 --at 0.006,0,-0.02
//! NEEDS 3.49238 N at thumb, 2.01636 N at index and 2.01636 N at middle at rest (0.349228 times the squeeze given), at most 5.89541 times the squeeze given, so that it holds and nothing slides
//!   if friction is 10 % less and the squeeze is 5 % less: 1.1696 times as much
//!   with less: TURNS OUT at 3.924 N of 3.924 N: the object turns about thumb, index and middle slide
//!   with more than 58.9558 N at thumb, 34.0387 N at index and 34.0387 N at middle at rest (5.89541 times the squeeze given): GOES TOO FAR at 3.924 N of 3.924 N: it turns by more than 5.7°; beyond this, results for small motions no longer apply. CAUTION, left out: as the forces turn with the parts they act on, they take 97 % of what resists, and motions are up to 34 times as large
//!   tried were 14 amounts from 0.03 to 10 times the squeeze given
//! ```
//!
//! # How far can I tip a bottle before it slips in my hand?
//!
//! ```text
//! $ grasp-lcp need bottle.json
//! TAKES 36.4985° and holds, 36.4669° and nothing slides
//!   if friction is 10 % less and the squeeze is 5 % less: 28.3438°
//!   with more: GOES TOO FAR at 36.4985°: it turns by more than 5.7°
//! ```
//!
//! # How hard do I have to pull to get a book out of a row?
//!
//! ```text
//! $ grasp-lcp need book.json
//! TAKES 7 times the load, 7 N, and holds, and nothing slides
//!   with more: SLIPS OUT at 7 N of 7 N: the object moves along −y, left front, left back, right front and right back slide (gross slip)
//! ```
//!
//! The program answers the opposite question: it gives the greatest pull that the book withstands, and any greater pull gets the book out. The
//! neighbours of the book press at four places, with 5 N each and a coefficient of friction of 0.35. Friction holds up to 4 · 0.35 · 5 N = 7 N, which
//! is 7 times the pull of 1 N in the scene.
//!
//! # Do my soft jaws carry a plate by its rim?
//!
//! ```text
//! $ grasp-lcp hold plate.json
//! HOLDS, everything sticks: 6.08 N (1.216 times this load) until it turns by more than 5.7°
//! ```
//!
//! # Which motor of my hand stalls first, and when?
//!
//! ```text
//! $ grasp-lcp hold hand.json
//! HOLDS, everything sticks: 7.09704 N (1.77426 times this load) until the first slip (right motor gives way), 8.33333 N (2.08333 times) until it is lost
//! ```
//!
//! The motor stalls at 0.5 N m. Its finger of 60 mm then presses with at most 8.33 N. That is 2.08 times the load of 4 N, once the other finger has
//! let go.
//!
//! # How far may I tilt a tray before the glass on it tips or slides?
//!
//! ```text
//! $ grasp-lcp need tray.json
//! TAKES 23.1985° anticlockwise and holds, 12.9946° and nothing slides
//!   if friction is 10 % less: 23.1986°
//!   with more: TIPS OVER at 23.1986°: the object tips over about left edge, right edge opens
//! ```
//!
//! The glass tips at tan⁻¹ (30 mm / 70 mm) = 23.2°, from half the width of its foot and the height of its centre of mass. As a whole it would slide
//! only at tan⁻¹ 0.5 = 26.6°. The first slip at 12.9946° is local. Tilting takes pressure from the upper edge of the foot, which then slides. The
//! lower edge still sticks and holds the glass.
