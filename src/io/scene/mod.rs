//! Scenes: grasps, and questions about them, as text (feature `serde`).
//!
//! A [`Scene`] is read and written by serde, from JSON or from any other self-describing format; its [answers](Scene::answers) are written the same
//! way. Input that cannot be read unambiguously is refused: unknown fields, unknown versions, lists of the wrong length, numbers out of range. Units
//! are those of the crate: SI, or any consistent units.
//!
//! # The format, version `grasp-lcp/1`
//!
//! The scene. Either `planar` or `spatial`:
//!
//! | field | value | if left out |
//! |---|---|---|
//! | `format` | `"grasp-lcp/1"` | an error |
//! | `$schema` | the place where an editor finds the JSON Schema (feature `schema`); the crate ignores it | none |
//! | `id` | a text or a whole number that answers repeat | none |
//! | `comment` | a text for the reader | none |
//! | `unit` | the unit of lengths, `"mm"`, `"cm"` or `"in"`, see below | `"m"` |
//! | `planar` | a setup in the plane: points, normals and commands have 2 numbers | `spatial` is needed |
//! | `spatial` | a setup in space: points, normals and commands have 3 numbers | `planar` is needed |
//!
//! A scene with `"unit": "mm"` has these lengths in mm: points, outlines, centres of mass, clearances; commands of contacts, prismatic joints and tendons;
//! arms of tendons at revolute joints; lengths in `soft`, `suction`, `surface`, `touches` and links; `at` and `about` of loads; a mesh without its own unit.
//! Stiffness, compliance, moment, inertia and acceleration stay in N/m, m/N, N m, N m/rad, kg m² and m/s². Answers are in m, as in other scenes.
//! `Scene::from_json` (feature `json`) reads such a scene.
//!
//! The setup:
//!
//! | field | value | if left out |
//! |---|---|---|
//! | `contacts` | a list of contacts whose fingers have no joints | none; an error if no finger has a contact either |
//! | `fingers` | a list of fingers with joints, see below | none |
//! | `tendons` | a list of tendons over their joints, see below | none |
//! | `bodies` | a list of several bodies, see below | one object |
//! | `links` | a list of hinges, slides, springs, cables between bodies or to the ground, see below | none |
//! | `gravity` | acceleration on the masses of bodies, m/s², in addition to the loads of questions | none |
//! | `loaded` | the name of the body that loads of questions act on | the first body |
//! | `shared_by_mass` | `true`: loads of questions act on all bodies, on each with the share of its mass; see wrenches | `false` |
//! | `outline` | corners of the object in order, m, a closed line that may go over itself; only drawn | none |
//! | `part` | the grasped part as a mesh, in space, see below (feature `mesh`) | none |
//! | `robot` | a robot from its description file, in space, see below (feature `urdf`) | none |
//! | `questions` | a list of questions | none |
//! | `settings` | settings for all questions | [`Settings::default`](crate::Settings) |
//!
//! A contact (see [`Contact`](crate::grasp::Contact) for signs and frames). Numbers are finite and at most 1e50 in magnitude; moreover friction may
//! be `"infinite"` and a spring `"rigid"`:
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `name`, `comment` | texts | | none |
//! | `on`, `against` | names of bodies: the normal points into `on`, and `against` is on the other side | | `on` is needed if there are bodies; `against` is the ground or a finger |
//! | `point` | point of contact | m | an error without `touches` |
//! | `normal` | direction into the object, of any length | | an error without `touches` |
//! | `touches` | a pad that closes on the part, in place of point and normal, see below (feature `mesh`) | | none |
//! | `tangent` | direction of the first tangent | | chosen from the normal |
//! | `body_stiffness` | the object's springs: `[normal, tangential]`, in space also `[normal, first tangent, second tangent]`; `"rigid"` in place of one number or of all | N/m | rigid, if the finger's springs are given |
//! | `finger_stiffness` | the finger's springs, in the same form | N/m | rigid, if the object's springs are given |
//! | `series_stiffness` or `stiffness` | springs of body and finger in series, in place of both; also one number for all directions | N/m | 1e4 in all directions if no stiffness is given; [`Setup::stiffness_left_out`] says whether an answer depends on it |
//! | `friction` | coefficient μ, or `"infinite"` | | 0 |
//! | `kinetic_friction` | coefficient of friction while the contact slides, at most `friction`; see [`Contact::kinetic`](crate::grasp::Contact::kinetic) | | `friction` |
//! | `command` | commanded displacement of the finger in the contact frame, normal part first | m | 0 |
//! | `command_world` | the same displacement along the coordinate axes, in place of `command` | m | not used |
//! | `pressed_with` | clamping force, in place of the normal command; see [`Contact::pressed_with`](crate::grasp::Contact::pressed_with) | N | |
//! | `force` | constant normal force, whatever the object's motion, in place of a position of the finger; see [`Contact::force`](crate::grasp::Contact::force) | N | not used |
//! | `clearance` | gap before anything moves, negative for an overlap | m | 0 |
//! | `hold` | `"unilateral"`, `"kept_closed"` or `"bonded"`, see [`Hold`](crate::grasp::Hold) | | unilateral |
//! | `suction` | a suction cup in place of the point: `{"radius": …, "pressure": …}` with m and Pa, or a `force`, N, in place of the pressure, and `points`, 12 if left out; see [`SuctionCup`](crate::grasp::SuctionCup). Or a number: the force of a vacuum within a soft fingertip | N | none |
//! | `soft` | the patch of a soft fingertip in place of the point, see below | | a point |
//! | `surface` | the curve or surface along which `improve` may move the contact, with its normal: in the plane `segment`, `polyline`, `spline`, `closed_spline` (points), `circle` (`centre`, `radius`), `arc` (also `from_deg`, `over_deg`); in space `rectangle` (`corner`, `sides`), `cylinder` (`axis` from end to end, `radius`), `sphere` (`centre`, `radius`), `triangles` (corners of each) | m, degrees | the contact stays in its place |
//!
//! The points of a patch share the stiffness of the contact; each has its friction, command, clearance and hold (see
//! [`SoftFingertip`](crate::grasp::SoftFingertip)). In space `{"ring": {"radius": …, "points": …}}`,
//! `{"disc": {"radius": …, "annuli": …, "points": …, "pressure": …}}` or `{"rectangle": {"sides": [a, b], "strips": [1, 1]}}`
//! with sides along the first and the second tangent, in the plane `{"pair":
//! {"width": …}}` or `{"pad": {"width": …, "strips": …, "pressure": …}}`. Lengths in m; the
//! pressure is `"uniform"` (if left out), `"parabolic"` or `"hertz"`.
//!
//! A part (module `touch`): `{"mesh": "part.stl", "unit": "mm", "density": 7850}`. The file ends in `.stl` or `.obj`, and a relative path counts from the
//! folder of the scene; `vertices` and `faces` may stand in its place. The unit is `m` (if left out), `cm`, `mm` or `in`; `mass`, kg, may stand in place of `density`, kg/m³. Pads touch it:
//!
//! | field of `touches` | value | unit | if left out |
//! |---|---|---|---|
//! | `rectangle` or `disc` | sides along the first and the second tangent, or the radius | m | an error |
//! | `round` or `v_deg` | of a rectangle: radius of a round finger, or opening angle of a V, along the second tangent | m, degrees | flat |
//! | `from`, `closing` | the middle of the pad before it closes, and the direction | m | an error |
//! | `layer` | `{"modulus": …, "thickness": …}` in place of a stiffness of the contact | Pa, m | none |
//! | `strips` | numbers of strips in half of each side, with two points each; of a disc, numbers of annuli and of points on a ring | | `[2, 2]`, `[2, 8]` |
//!
//! `pressed_with` of a contact that `touches` is its force along the closing direction.
//!
//! A body (see [`Bodies`](crate::grasp::Bodies)):
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `name` | the name for contacts and answers | | an error |
//! | `comment` | a text | | none |
//! | `mass`, `centre_of_mass` | the mass on which `gravity` acts, and its centre | kg, m | 0, the origin |
//! | `load` | a constant wrench on the body | N, N m | none |
//! | `outline` | corners in order; only drawn | m | none |
//!
//! A link (see [`Link`](crate::grasp::Link)) has exactly one of the fields `hinge`, `ball`, `slide`, `rigid`, `spring` and `cable`, and names the
//! bodies that it joins:
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `name`, `comment` | texts | | the kind of link and its number |
//! | `hinge` | `{"point": …}`, in space with its `axis` and the `length` between its bearings | m | |
//! | `ball` | in space `{"point": …}` | m | |
//! | `slide` | `{"point": …, "direction": …, "length": …}` with the length between its bearings | m | |
//! | `rigid` | `{"point": …, "size": …}` | m | |
//! | `spring`, `cable` | `{"from": …, "to": …}` | m | |
//! | `between` | names of two bodies; `from` is on the first, `to` on the second | | to the ground |
//! | `on` | the body that the link joins to the ground | | an error with several bodies and no `between` |
//! | `stiffness` | stiffness along each direction in which the link prevents relative motion | N/m | 1e9; of a spring an error |
//! | `pretension` | pull of a spring or a cable before anything moves | N | 0 |
//! | `tension` | in place of `pretension`: the pull without load, after all other springs have deflected | N | not used |
//! | `slack` | the length of a cable in excess of the distance between its ends | m | 0 |
//!
//! Lists with an entry for each contact have no entries for links.
//!
//! A finger (see [`Finger`](crate::grasp::Finger) for signs):
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `comment` | a text | | none |
//! | `joints` | a list of joints from the palm on | | none |
//! | `stiffness_matrix` | rows of the symmetric stiffness matrix of its joints, added to their own springs | N m/rad | none |
//! | `compliance` | rows of the symmetric compliance matrix of its contacts, ordered by contact and then by axis of its frame | m/N | none |
//! | `presses_with` | the `force` of its only contact | N | not used |
//! | `contacts` | a list of contacts, at least one; stiffness may be left out if there is a `compliance` | | an error |
//!
//! Its contacts may name the joints that move them: `"moved_by": {"link": 1}`, the number of the finger's joints counted from the palm, or
//! `"moved_by": {"jacobian": [[…], …]}`, one row a coordinate axis and one column a joint; in space three more rows, angular velocities of the link,
//! may follow, and must follow for a soft fingertip. Without `moved_by` all joints of the finger move the contact. Contacts of fingers are numbered
//! after the contacts of the list `contacts`. Every contact with a `force` has a slide: a prismatic joint, numbered after all joints of fingers.
//!
//! A joint is `"revolute"` – `{"point": [x, y]}` in the plane, `{"point": …, "axis": …}` in space –, `"prismatic"` (a direction), or neither,
//! and then known by the Jacobians of its contacts alone. A tendon has `arms`, one for each joint of all fingers, in m/rad, or without a unit at a
//! prismatic joint:
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `name` | a text | | none |
//! | `stiffness` | stiffness of its drive | N m/rad or N/m, of a tendon N/m | none: only `torque` or `tension` acts |
//! | `command`, of a tendon `pull` | commanded position of its drive | rad or m | 0 |
//! | `torque`, of a tendon `tension` | constant torque or force in addition to the drive | N m or N | 0 |
//! | `limit` | `{"saturates": …}` or `{"slips": …}`, see [`Limit`](crate::grasp::Limit) | N m or N | none |
//! | `pushes`, of a tendon alone | `true` for a rod or a differential, which also pushes | | pulls only |
//!
//! A robot (`RobotSetup` of the feature `urdf`) is `{"urdf": "hand.urdf", "joints": {"thumb_base": 20}, "stiffness": {"others": 3}, "contacts":
//! {"thumb_tip": […]}}`, in space. Contacts on its links that no joint moves are numbered after the contacts of the list `contacts`; its other
//! contacts after those of all other fingers, finger by finger.
//!
//! A wrench is `{"force": [0, -1], "moment": 0.2}` in the plane and `{"force": [0, 0, -1],
//! "moment": [0, 0.1, 0]}` in space, N and N m about the origin; a part that is left out is zero. `"at":
//! [0.1, 0]` lets the force act there (m): its moment is added. A body that an arm carries is a load, too; see [`Payload`](crate::grasp::Payload):
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `mass` | its mass, centred `at` | kg | no body |
//! | `gravity` | acceleration of gravity along every axis | m/s² | that of the scene, or 9.81 down the last axis |
//! | `accelerated` | acceleration of the arm; of a turning arm, the acceleration of the point about which it turns | m/s² | none |
//! | `turning` | `about` a point (m) with `velocity_deg` and `acceleration_deg` or `…_rad`: a number in the plane, in space three along the axis | degrees or rad a second, and a second squared | none |
//! | `inertia` | about its centre: a number in the plane, in space three about axes along the coordinates | kg m² | an error if the load depends on it |
//!
//! `Scene::from_json` (feature `json`) lets a force, weight or mass without `at` and `moment` act at the common centre of mass if loads are
//! `shared_by_mass`: each body then carries its part at its own centre of mass. With `shared_by_mass`, or on a single body under `gravity`,
//! `accelerated` without a `mass` accelerates the bodies by their own masses.
//!
//! A question is an object with one field:
//!
//! | field | with | asks for |
//! |---|---|---|
//! | `hold` | `base`, `load` (wrenches), `together_with` | whether the grasp holds the load as it grows from zero, at which load a contact first slips, and at which load equilibrium is lost |
//! | `need` | `quantity`, loads, `together_with` | the least squeeze or friction that the grasp needs, or the largest load, arm or angle that it holds, see [`Need`](crate::need::Need) |
//! | `improve` | `base`, loads, `at_most`; a `surface` of contacts | better places of the fingers, and their clamping forces, see [`Improve`](crate::improve::Improve) |
//! | `solve` | `load` (a wrench), `together_with` | the equilibrium under the load |
//! | `compare` | `base`, `load` (wrenches) | whether the minimum of energy, from a quadratic program, is the equilibrium, and up to which multiple of the load, see [`energy`](crate::energy) |
//! | `onset` | `base`, `direction` (wrenches), `command_change`, `joint_change`, `together_with` | the onset of sliding under `base + τ direction`, while commands change by τ times `command_change` and `joint_change` |
//! | `onset_of_turn` | a turn | the onset of sliding while the load turns |
//! | `follow` | `start` (a wrench), `legs`, `in_steps` | the load path of a load program. With `in_steps`, the error that each leg may add to forces, the path is followed in steps, which suits hundreds of contacts |
//! | `shake` | `base` (a wrench), `loads` or `legs` | whether slip ceases, alternates or accumulates under loads that are repeatedly applied and removed, or under a repeated cycle of legs |
//! | `identify` | `unknowns`, `slips` (with a `group` if they share measurement errors), `layouts`, `known` | friction, loads of supports, squeeze or stiffness from observed slips, see [`Identify`](crate::identify::Identify) |
//! | `shakedown` | `base` (a wrench), `loads` | the multiple of the loads up to which the grasp could come to rest, in any order of the loads |
//!
//! With several bodies `together_with` has loads on other bodies by name, `{"upper": {"force": [-5, 0]}}`, in proportion to the load. `base` must
//! then be left out.
//!
//! Wrenches that are left out are zero. `command_change` and all other commands are one row for each contact of the scene (m, in its contact frame),
//! which holds for all points of a soft fingertip. A leg, i.e. a section of a load program, has `load_by` or `load_to` (a wrench), `commands_by` or
//! `commands_to` (rows), `joints_by` or `joints_to`, `torques_by` or `torques_to`, or one of each, or a `turn` alone: the load then changes as the
//! turn does, from its value at the start of the leg. All that a leg does not mention stays constant. With several bodies `body_loads_by` or
//! `body_loads_to` have loads on bodies by name, on top of their own, which change independently of the load. `joint_change` and `joints_by`
//! have one number for each joint and then each tendon. `torques_by` has one number for each joint: the change of its constant torque or force, N m
//! or N. Slides of contacts with a `force` come last.
//!
//! A turn (see [`Turn`](crate::load_path::Turn)) is a `weight` while the object is tilted with its grasp, or a `force` that turns, or three
//! wrenches. In the plane it goes from x to y, in space about the axis by the right-hand rule:
//!
//! | field | value | unit | if left out |
//! |---|---|---|---|
//! | `weight` or `force` | a row of components | N | a turn of three wrenches |
//! | `at` | the point where the load acts | m | the origin |
//! | `axis` | the axis of the turn in space, of any length but zero | | an error; it must be left out in the plane |
//! | `beside` | a constant wrench | N, N m | none |
//! | `constant`, `cosine`, `sine` | wrenches, in place of all these: `constant + cosine cos θ + sine sin θ` | N, N m | zero; `cosine` or `sine` is needed |
//! | none of these | the scene's own `gravity` turns, with the weights of all its bodies; only in `onset_of_turn` and `need` | | |
//! | `angle_deg` or `angle_rad` | the angle of the turn, more than 0 and at most 1e6 rad | degrees or rad | a full turn |
//! | `reversed` | `true` for a turn in the opposite direction | | `false` |
//!
//! The settings (see [`Settings`](crate::Settings)):
//!
//! | field | value | if left out |
//! |---|---|---|
//! | `cone` | in space `"round"`, or `"polygon"` for answers on the polygonal cone itself, onsets included | round |
//! | `polygon` | `{"facets": …, "fit": "inscribed"}`, or `"circumscribed"` or `"balanced"` | 8, inscribed |
//! | `max_pivots` | largest number of pivots of Lemke's method | set by the size of the problem |
//! | `most_states` | most combinations of contact states to try | 20 000 |
//! | `step_error` | relative error of one step along a sliding arc, a piece of a path on which directions of sliding turn; between 0 and 1 | 1e-9 |
//! | `most_steps` | most steps along sliding arcs and jumps within a leg | 20 000 |
//! | `most_load` | largest multiple of the load up to which `hold` searches for the loss of equilibrium | 100 |
//! | `most_cycles` | most cycles of a repeated load that are computed | 1 000 |
//! | `small_motions` | `rotation` (rad) and `slip` (part of the grasp's size) up to which motions are small: a load with larger motions does not count as held | 0.1 and 0.1 |
//!
//! Two fingers in the plane:
//!
//! ```
//! use grasp_lcp::scene::{Answer, OnsetAnswer, Scene};
//!
//! let scene: Scene = serde_json::from_str(r#"{
//!     "format": "grasp-lcp/1",
//!     "planar": {
//!         "contacts": [
//!             {
//!                 "name": "left", "point": [-4, 1.8], "normal": [8, -1],
//!                 "body_stiffness": [10, 10], "finger_stiffness": [10, 10],
//!                 "friction": 0.25, "command": [0.1, -0.0125]
//!             },
//!             {
//!                 "name": "right", "point": [4, 1.8], "normal": [-8, -1],
//!                 "body_stiffness": [10, 10], "finger_stiffness": [10, 10],
//!                 "friction": 0.25, "command": [0.1, 0.0125]
//!             }
//!         ],
//!         "questions": [{ "onset": { "direction": { "force": [0, -1] } } }]
//!     }
//! }"#)?;
//! let answers = scene.answers()?;
//! let [Answer::Onset(OnsetAnswer::At(onset))] = answers.list() else { panic!("{answers:?}") };
//! assert!((onset.at.factor - 65f64.sqrt() / 66.0).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A block in space on a bonded foot and a soft fingertip that presses from above and is dragged
//! sideways:
//!
//! ```
//! use grasp_lcp::scene::Scene;
//!
//! let scene: Scene = serde_json::from_str(r#"{
//!     "format": "grasp-lcp/1",
//!     "id": 7,
//!     "spatial": {
//!         "contacts": [
//!             {
//!                 "name": "foot", "point": [0, 0, -0.05], "normal": [0, 0, 1],
//!                 "series_stiffness": [5e4, 4e4, 3e4], "friction": "infinite", "hold": "bonded",
//!                 "soft": { "ring": { "radius": 0.05, "points": 6 } }
//!             },
//!             {
//!                 "name": "index", "point": [0, 0, 0.05], "normal": [0, 0, -1], "tangent": [1, 0, 0],
//!                 "body_stiffness": "rigid", "finger_stiffness": [1500, 900],
//!                 "friction": 0.6, "command": [0.004, 0, 0],
//!                 "soft": { "disc": { "radius": 0.006, "annuli": 1, "points": 4, "pressure": "hertz" } }
//!             }
//!         ],
//!         "questions": [
//!             { "solve": { "load": { "force": [0, 0, -2], "at": [0.01, 0, 0] } } },
//!             { "follow": { "legs": [{ "commands_by": [[0, 0, 0], [0, 0.008, 0]] }] } }
//!         ],
//!         "settings": { "polygon": { "facets": 12 }, "step_error": 1e-10 }
//!     }
//! }"#)?;
//! let answers = serde_json::to_value(scene.answers()?)?;
//! assert_eq!(answers[0]["solve"]["outcome"], "equilibrium");
//! assert_eq!(answers[1]["follow"]["outcome"], "completed");
//! assert_eq!(answers[1]["follow"]["events"][0]["changes"][0]["name"], "index");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Answers
//!
//! A scene has one [`Answer`] for each question, under the name of the question: `{"solve": {"outcome":
//! "equilibrium", …}}`. The outcome comes first, and only an equilibrium has forces, with its
//! residuals:
//!
//! | question | outcomes | type |
//! |---|---|---|
//! | `hold` | the sentence `says`, and as `holding` one of `sticks`, `slides`, `turns_over`, `loose`, `lost`, `no_rest`, `lost_at_rest`, `undecided` | [`HoldAnswer`] |
//! | `need` | the sentence `says`, and as `amount` one of `bound`, `any`, `none`, `undecided` | [`NeedAnswer`] |
//! | `improve` | the sentence `says`, and as `search` one of `optimum`, `stalled`, `out_of_steps`, `unbalanced`, `nothing_slides`, `no_start` | [`ImproveAnswer`] |
//! | `solve` | `equilibrium`, `no_equilibrium`, `undecided` ; if that does not decide whether the load is held, `from_rest` has the answer of `hold` | [`SolveAnswer`] |
//! | `compare` | the sentence `says`, `agrees_up_to`, and as `verdict` one of `agree`, `two_equilibria`, `out_of_equilibrium`, `no_equilibrium`, `unknown`, `no_minimum`, `unsolved` | [`CompareAnswer`] |
//! | `onset` | `at`, `never`, `already_sliding`, `no_base`, `gives_way`, `undecided` | [`OnsetAnswer`] |
//! | `onset_of_turn` | as for `onset`, with `angle_rad` in place of the factor, and the contacts that touch their limit before first slip | [`TurnAnswer`] |
//! | `follow` | `completed`, `lost`, `no_start`, `undecided` | [`PathAnswer`] |
//! | `shake` | the sentence `says`, and as `repeats` one of `rests`, `dies_out`, `alternates`, `walks`, `lost`, `no_rest`, `undecided` | [`ShakeAnswer`] |
//! | `identify` | the sentence `says`, and as `ending` one of `converged`, `not_converged`, `not_predicted` | [`IdentifyAnswer`] |
//! | `shakedown` | the sentence `says`, `rests` if the order does not matter, and `factor`, `slips`, `binding` if known | [`ShakedownAnswer`] |
//!
//! The names in the text are the names of the fields and variants of these types, in lower case with underscores. The types contain the answers of a
//! [`Grasp`](crate::ask::Grasp), and results that it computes on request only. Contacts are named by their index in the scene and, for a soft
//! fingertip, the point of its patch; joints and tendons by their number and name. Motions have the displacements of joints in `joints`. A number
//! that is not finite is written in words: `"infinite"`, `"-infinite"`, `"not a number"`. Fields may be added to answers without a new version.
//!
//! Numbers that are written and read again keep every bit if the format does so; `serde_json` needs its feature
//! `float_roundtrip`.
//!
//! # Errors
//!
//! A scene that can be read has numbers in range and lists of matching length. Messages name the
//! contact's data, the value and the allowed values. `Scene::from_json` (feature `json`) adds line and column and the
//! path of the field, `planar.contacts[1].friction`. A probable mistake that can still be answered gives a [`Warning`].

#[cfg(feature = "schema")]
mod schema;

mod answer;
mod asked;
mod at_rest;
mod body;
mod brief;
#[cfg(feature = "json")]
mod centre_of_mass;
mod compared;
mod cup;
mod face;
#[cfg(feature = "json")]
mod fault;
#[cfg(feature = "json")]
mod field_path;
mod finger;
mod fingertip;
mod first_line;
mod given_answers;
mod growing;
mod joint;
mod labels;
mod left_out;
#[cfg(feature = "json")]
mod lengths;
mod link;
mod load_by_mass;
mod matrix;
mod onset;
mod own_weight;
#[cfg(feature = "mesh")]
mod part;
mod patch;
mod path;
#[cfg(feature = "json")]
mod plain_words;
mod question;
#[cfg(feature = "urdf")]
mod robot;
mod sentence_answers;
mod settings;
mod setup;
mod solved;
mod springs;
mod surface;
mod suspicious_numbers;
mod tangential;
mod tolerances;
mod turn;
mod warning;
mod warning_words;
#[cfg(feature = "json")]
mod weight_twice;
mod wrench;
mod written;
mod written_contact;

pub use answer::Answer;
pub use body::BodySetup;
pub use brief::Brief;
pub use compared::CompareAnswer;
pub use cup::Cup;
#[cfg(feature = "json")]
pub use fault::{Fault, FaultKind, TextPosition};
pub use finger::FingerSetup;
pub use fingertip::{Fingertip, MovedBy};
pub use link::LinkSetup;
pub use onset::{Angle, Factor, OnsetAnswer, OnsetAt, TurnAnswer};
#[cfg(feature = "mesh")]
pub use part::{PadLayer, PadTouch, PartSetup};
pub use patch::FingertipPatch;
pub use path::{BalancedEnergy, PathAnswer, PathOutcome};
pub use question::Question;
#[cfg(feature = "urdf")]
pub use robot::{MotorLimits, RobotSetup};
pub use sentence_answers::{
    HoldAnswer, IdentifyAnswer, ImproveAnswer, NeedAnswer, ShakeAnswer, ShakedownAnswer,
};
pub use setup::Setup;
pub use solved::SolveAnswer;
pub use warning::Warning;
pub use written::{Answers, FORMAT, Id, Scene};
