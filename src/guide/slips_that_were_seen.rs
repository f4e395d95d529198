//! Observed slips: estimates of friction, loads of supports, squeeze and stiffness.
//!
//! Every question needs friction, and it is rarely known. It can be observed: pull until the object slides, note the load, and repeat. The estimate
//! comes with a standard error, and both can be used in other questions. The scenes are in `examples/scenes/slips`, and the commands are run there.
//!
//! # A block is pushed about on three points. What is its friction, and what does each point carry?
//!
//! The table has a line `fx,fy,mz` for each of 50 pushes under which the block slid, measured by Zhou, Paolini, Bagnell and Mason (ICRA 2016). A
//! scale gives the total load of the three points, 14.876 N to 0.1 %. The option `--known 1+2+3=14.876,0.1` states this sum of the parameters 1, 2
//! and 3, counted from 0 in the order of the options `--unknown`.
//!
//! ```text
//! $ grasp-lcp identify block.json block.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c --known 1+2+3=14.876,0.1
//! friction 0.3036 ± 0.0032 (95 %: 0.2973 to 0.3101), load of a 3.30 N ± 0.29 N (95 %: 2.78 N to 3.94 N), load of b 7.66 N ± 0.21 N (95 %: 7.25 N to 8.10 N), load of c 3.91 N ± 0.18 N (95 %: 3.57 N to 4.28 N) from 50 slips, which scatter by 7.2 %
//! ```
//!
//! By statics the points carry 3.72, 7.44 and 3.72 N. Without the scale only products are determined, and the answer says so:
//!
//! ```text
//! $ grasp-lcp identify block.json block.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c
//! friction not fixed, load of a not fixed, load of b not fixed, load of c not fixed from 50 slips, which scatter by 7.2 %. Friction may be greater by any factor where load of a, load of b and load of c are smaller by it
//! ```
//!
//! # Observations that share errors
//!
//! Fifty pushes are not fifty independent measurements if all pushes in one direction slid over the same patch of the surface. A column `group` marks
//! observations that may share an error: a direction, a specimen, a day. The same pushes, with pushes whose directions lie within 30° as one group:
//!
//! ```text
//! $ grasp-lcp identify block.json block_by_direction.csv --unknown friction --unknown carried=a --unknown carried=b --unknown carried=c --known 1+2+3=14.876,0.1
//! friction 0.3036 ± 0.0021 (95 %: 0.2982 to 0.3092), load of a 3.30 N ± 0.31 N (95 %: 2.25 N to 4.85 N), load of b 7.66 N ± 0.41 N (95 %: 6.51 N to 9.01 N), load of c 3.91 N ± 0.13 N (95 %: 3.50 N to 4.36 N) from 50 slips in 8 groups, which scatter by 7.2 %
//! ```
//!
//! The estimates are the same; their uncertainty now follows from the scatter between the groups. Few groups determine the uncertainty poorly.
//! Intervals are those of Student's distribution with the remaining degrees of freedom. Without the column each observation is its own group.
//!
//! # What can be estimated
//!
//! | option `--unknown` | parameter that is estimated | prerequisite |
//! |---|---|---|
//! | `friction` | a coefficient, of all contacts or of some | the normal forces: from clamping forces, or from a weight |
//! | `carried` | normal force of a support before the object is pushed, N | friction, or the sum of the loads from a scale |
//! | `squeeze` | factor of the given clamping forces | friction |
//! | `stiffness` | factor of the given tangential stiffness | friction; only observations of first slip determine it |
//!
//! Gross slip, in which the whole object slides, is easy to observe, and usually depends on friction and normal forces alone. First slip, of a single
//! contact, also depends on stiffness. A column `slip` of the table, or `--first`, says which of the two was observed. Several parameters need loads
//! with several directions or moments: slip that always occurs in the same way determines one number.
//!
//! Of two jaws the one with less friction slips. Such observations determine its coefficient, but not which jaw it is: *one of the two is 0.423 ± 0.004, which one is not fixed*. The
//! answer then has the estimates of each assignment. Observations under loads nearer to one jaw decide between the assignments.
//!
//! # Contents of the answer
//!
//! * `±` is the standard error, followed by the interval that contains the true value in 95 of 100 cases. If the scatter of the loads is not given it
//!   is estimated, and the interval is that of Student's distribution.
//! * A parameter that the observations do not determine has no number. The answer names the product, sum or ratio that they do determine.
//! * An observation that is off by more than two standard deviations has a smaller weight, so that a single wrong entry does little harm; the answer
//!   counts such observations.
//! * With a given scatter, observations that are much farther off show that the model is wrong. Friction may vary, or a load may have acted at
//!   another place than stated.
//!
//! # Use in other questions
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
//! let found = gripper.identify(&asked)?;
//!
//! // The grasp with the estimated friction; the needed squeeze allows for the lower end of its interval.
//! let known = asked.grasp_with(&gripper, &found)?;
//! let weight = Wrench::force([0.0, -5.0]);
//! let needed = known.need(&Need::squeeze(weight).if_lower_by(found.friction_less(), found.squeeze_less()))?;
//! assert!(needed.safe.is_some());
//!
//! // Standard errors as standard deviations, with two of them in reserve.
//! let reserve = known.reserve(Wrench::ZERO, &found.uncertainty(1), 2.0)?;
//! # let _ = reserve;
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! In Python: `grasp.identify(["friction"], loads)`, with a row for each observation (and `group=`, a name for each); `found.estimates[0].value`,
//! `.standard_error` and `.interval`.
