//! Slips that were seen: what they tell of friction, of what supports carry, of squeeze and stiffness.
//!
//! Friction is what everybody asks this crate for, and what nobody knows. It can be seen: pull until it slides, and write the load down, some times. What is found comes with its
//! error, and goes on into what else is asked. The scenes are those of `examples/scenes/slips`, and the commands are typed there.
//!
//! # A block is pushed about on three points. What is its friction, and what does each point carry?
//!
//! The table has a line for each of 50 pushes under which the block slid, measured by Zhou, Paolini, Bagnell and Mason (ICRA 2016): `fx,fy,mz`. A scale says what the points carry together, 14.876 N to 0.1 %.
//!
//! ```text
//! $ grasp-lcp identify block.json block.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c --known 1+2+3=14.876,0.1
//! friction 0.3036 ± 0.0032 (95 %: 0.2973 to 0.3101), load of a 3.30 N ± 0.29 N (95 %: 2.78 N to 3.94 N), load of b 7.66 N ± 0.21 N (95 %: 7.25 N to 8.10 N), load of c 3.91 N ± 0.18 N (95 %: 3.57 N to 4.28 N) from 50 slips, which scatter by 7.2 %
//! ```
//!
//! By statics they carry 3.72, 7.44 and 3.72 N. Without the scale only products are fixed, and that is said:
//!
//! ```text
//! $ grasp-lcp identify block.json block.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c
//! friction not fixed, load of a not fixed, load of b not fixed, load of c not fixed from 50 slips, which scatter by 7.2 %. Friction may be greater by any factor where load of a, load of b and load of c are smaller by it
//! ```
//!
//! # Slips that share errors
//!
//! Fifty pushes are not fifty measurements if all that went one way found the same patch of the surface. A column `group` says which slips may have that in common: a direction, a
//! specimen, a day. The same pushes, those within 30° of direction as a group:
//!
//! ```text
//! $ grasp-lcp identify block.json block_by_direction.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c --known 1+2+3=14.876,0.1
//! friction 0.3036 ± 0.0021 (95 %: 0.2982 to 0.3092), load of a 3.30 N ± 0.31 N (95 %: 2.25 N to 4.85 N), load of b 7.66 N ± 0.41 N (95 %: 6.51 N to 9.01 N), load of c 3.91 N ± 0.13 N (95 %: 3.50 N to 4.36 N) from 50 slips in 8 groups, which scatter by 7.2 %
//! ```
//!
//! What is found stays as it is; how sure it is comes from how far the groups are apart. Few groups say little about that, and intervals are Student's with the degrees of freedom that they leave.
//! Without the column slips stand for themselves.
//!
//! # What can be sought
//!
//! | unknown | what it is | what must be known |
//! |---|---|---|
//! | `friction` | a coefficient, of all contacts or of some | what presses: the squeeze, or a weight |
//! | `carried` | what a support carries at rest, N | friction, or the sum by a scale |
//! | `squeeze` | how many times the squeeze given | friction |
//! | `stiffness` | how many times the tangential stiffness given | friction; from first slips alone |
//!
//! Gross slip is what is easily seen, and as a rule depends on friction and normal forces alone. First slip depends on stiffness, too: say `slip` in the table, or `--first`. Slips of several unknowns need loads
//! of several directions or moments: those that always slide in the same way fix one number.
//!
//! # What is told
//!
//! * `±` is the standard error; behind it stands what holds the truth in 95 of 100 cases. Where the scatter of the loads is not given it is estimated, and the interval is Student's.
//! * What the slips do not fix has no number. Why is said: a product, a sum or a ratio that is all they fix.
//! * A slip that is off by more than two standard deviations counts less, so that one that was written down wrong does little harm; how many do is said.
//! * With a scatter that is given, slips that are much farther off say that the model is wrong. Friction may not be the same everywhere, or a load did not act where it was said to.
//!
//! # Into other answers
//!
//! ```
//! use grasp_lcp::identify::{Identify, Slip, Unknown};
//! use grasp_lcp::need::Need;
//! use grasp_lcp::planar::{Contact, Grasp, Wrench};
//!
//! let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
//! let gripper = Grasp::new([jaw(-0.04), jaw(0.04)])?;
//! let slips = [7.9, 7.2, 7.6, 8.3, 7.7, 7.4].map(|newtons| Slip::gross(Wrench::force([0.0, -newtons])));
//! let asked = Identify::new([Unknown::friction()], slips);
//! let found = asked.answered_by(&gripper)?;
//!
//! // The grasp with the friction that was found, and how much less that may be.
//! let known = asked.grasp_with(&gripper, &found)?;
//! let weight = Wrench::force([0.0, -5.0]);
//! let needed = known.need(&Need::squeeze(weight).if_lower_by(found.friction_less(), found.squeeze_less()))?;
//! assert!(needed.safe.is_some());
//!
//! // Standard errors as standard deviations, with two of them in reserve.
//! let reserve = known.reserve(&Wrench::ZERO, &found.uncertainty(1), 2.0)?;
//! # let _ = reserve;
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! In Python: `grasp.identify(["friction"], loads)`, with a row for each slip (and `group=`, a name for each); `found.estimates[0].value`, `.standard_error` and `.interval`.
