//! Lemke's method on lists of contact states makes the pivots of the dense solver with the same covering vector.
//!
//! A scene is *settled* when no gap and no variable of a closed contact is close to zero in the dense answer, and none larger than precision allows. At an
//! open contact every friction row is zero once z₀ is: which of its facets are basic in the end is arbitrary, and it is compared as open. When the dense
//! solver overlooks such a tie in the rounding of its tableau, it makes a few pivots more before z₀ leaves, or ends on a ray. Where a scene
//! is not settled (no contact carries any force, or it is symmetric) several variables reach zero together; both solvers break such ties by a vector
//! without structure, but not by the same one, since the dense solver balances its rows first.

use grasp_lcp::ask::Grasp;
use grasp_lcp::ask::{Search, Workspace};
use grasp_lcp::forms::{Form, Row};
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::lcp::{self, Outcome, Solution};
use grasp_lcp::{PolygonCone, Settings};
use grasp_lcp::{planar, spatial};
use nalgebra::{DVector, SVector};
use std::cell::RefCell;
use std::f64::consts::TAU;
use support::jaws::around;
use support::random::{Spread, for_all, scene};
use support::samples::{assert_met, samples};

/// Below this part of the largest entry of q a variable may be zero.
const CLEAR: f64 = 1e-9;

/// Combinations of contact states that are listed at most.
const MOST_STATES: usize = 200_000;

/// The state of a contact in a basis: open, or the facets that slip.
type States = Vec<Option<Vec<usize>>>;

/// How the two solvers fared on the same scenes.
#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    scenes: usize,
    /// Both solved it, with the same states and as many pivots.
    same: usize,
    other_pivots: usize,
    other_states: usize,
    only_dense: usize,
    only_structured: usize,
    neither: usize,
    pivots: usize,
}

impl Tally {
    fn count(&mut self, dense: Option<&(States, usize)>, structured: Option<&(States, usize)>) {
        self.scenes += 1;
        match (dense, structured) {
            (None, None) => self.neither += 1,
            (Some(_), None) => self.only_dense += 1,
            (None, Some(_)) => self.only_structured += 1,
            (Some(a), Some(b)) => {
                self.pivots += a.1;
                if a == b {
                    self.same += 1;
                } else if a.0 == b.0 {
                    self.other_pivots += 1;
                } else {
                    self.other_states += 1;
                }
            }
        }
    }
}

#[derive(Debug, Default, Clone, Copy)]
struct Tallies {
    /// Settled, every contact closed.
    closed: Tally,
    /// Settled, some contact open.
    opening: Tally,
    unsettled: Tally,
}

impl Tallies {
    fn compare<const C: usize>(&mut self, grasp: &Grasp<C>, load: &Wrench<C>) {
        let cone = PolygonCone::default();
        let Ok(Some(form)) = grasp.kinematic_form(load, &cone) else { return };
        let ones = DVector::from_element(form.rows.len(), 1.0);
        let settings = lcp::Settings::default().with_covering(ones).with_retries(0).with_enumerate_up_to(0);
        let (mut dense, mut settled) = (None, true);
        if let Outcome::Solved(solution) = form.lcp.solve_with(&settings) {
            let found = states(grasp.len(), solution.basis.iter().map(|i| form.rows[i]));
            settled = is_settled(&form, &solution, &found);
            dense = Some((found, solution.pivots));
        }
        let mut workspace = Workspace::new(cone);
        let structured = match workspace.solve_along_one_path(grasp, load).expect("finite") {
            Search::Found(view) => Some((states(grasp.len(), view.jumps()), view.pivots())),
            _ => None,
        };
        if let (true, Some((one, _)), Some((other, _))) = (settled, &dense, &structured)
            && one != other
        {
            // Both may be right: where all states can be listed there are several equilibria.
            let on_polygons =
                Settings::default().with_cone(cone).on_the_polygon().with_most_states(MOST_STATES);
            let several = grasp.with(&on_polygons).equilibria(load).is_ok_and(|all| all.len() > 1);
            let too_many = 10_f64.powi(i32::try_from(grasp.len()).unwrap()) > 2.0 * MOST_STATES as f64;
            assert!(several || too_many, "{one:?} {other:?}");
        }
        let opens = dense.as_ref().is_some_and(|(states, _)| states.contains(&None));
        let tally = match (settled, opens) {
            (true, false) => &mut self.closed,
            (true, true) => &mut self.opening,
            (false, _) => &mut self.unsettled,
        };
        tally.count(dense.as_ref(), structured.as_ref());
    }
}

fn contact_of(row: Row) -> usize {
    match row {
        Row::Gap { contact } | Row::Slip { contact, .. } => contact,
        _ => unreachable!("another form"),
    }
}

fn states(contacts: usize, jumps: impl Iterator<Item = Row>) -> States {
    let mut states = vec![Some(Vec::new()); contacts];
    for row in jumps {
        match row {
            Row::Slip { contact, facet } => {
                if let Some(facets) = &mut states[contact] {
                    facets.push(facet);
                }
            }
            row => states[contact_of(row)] = None,
        }
    }
    for facets in states.iter_mut().flatten() {
        facets.sort_unstable();
    }
    states
}

fn is_settled(form: &Form, solution: &Solution, states: &States) -> bool {
    let size = form.lcp.vector().amax();
    let clear = CLEAR * size;
    solution.z.amax() < size / CLEAR
        && (0..form.rows.len()).all(|i| {
            let basic = if solution.basis.contains(i) { solution.z[i] } else { solution.w[i] };
            let friction = matches!(form.rows[i], Row::Slip { .. });
            (friction && states[contact_of(form.rows[i])].is_none()) || basic > clear
        })
}

fn random<const D: usize, const C: usize>(
    count: std::ops::Range<usize>,
    spread: Spread,
    cases: usize,
) -> Tallies {
    let tallies = RefCell::new(Tallies::default());
    for_all(file!(), cases, &scene::<D, C>(count, spread, 0.3), |mut scene| {
        for contact in &mut scene.contacts {
            // Without facets an open contact could go on pulling, and the workspace refuses what the dense solver accepts.
            contact.friction = contact.friction.min(1e6);
        }
        tallies.borrow_mut().compare(&scene.grasp(), &scene.wrench());
        Ok(())
    });
    tallies.into_inner()
}

/// With every contact closed nothing may differ, with open ones no state. Of 300 scenes with open contacts one may have a tie on the way, which rounding
/// decides: the path may then end in another equilibrium.
fn agree(tallies: &Tallies) {
    let (closed, opening) = (tallies.closed, tallies.opening);
    assert_eq!(closed.same + closed.neither + closed.only_structured, closed.scenes);
    assert_eq!(opening.same + opening.other_pivots + opening.other_states, opening.scenes);
    assert!(opening.other_states * 300 <= opening.scenes, "{opening:?}");
}

/// Where a variable is zero up to rounding, rounding decides which of two bases it belongs to: in so many scenes at most.
fn unsettled_agree_but_for(exceptions: usize, unsettled: &Tally) {
    assert_met(&[(unsettled.scenes, 12)]);
    assert!(unsettled.same + samples(exceptions) >= unsettled.scenes, "{unsettled:?}");
}

#[test]
fn random_scenes_in_the_plane() {
    let tallies = random::<3, 2>(2..9, Spread::Narrow, 750);
    agree(&tallies);
    let Tallies { closed, opening, unsettled } = tallies;
    assert_met(&[(closed.same + opening.same, 650), (closed.pivots + opening.pivots, 3000)]);
    assert_eq!(opening.other_pivots, 0);
    unsettled_agree_but_for(1, &unsettled);
}

#[test]
fn random_scenes_in_space() {
    let tallies = random::<6, 3>(3..9, Spread::Narrow, 750);
    agree(&tallies);
    let Tallies { closed, opening, unsettled } = tallies;
    assert_met(&[(closed.same + opening.same, 600), (closed.pivots + opening.pivots, 5000)]);
    assert!(opening.other_pivots < samples(20), "{opening:?}");
    unsettled_agree_but_for(4, &unsettled);
}

/// More than are looked at one by one: the others wait until their slack is used up.
#[test]
fn random_scenes_of_many_contacts() {
    let plane = random::<3, 2>(24..60, Spread::Narrow, 50);
    let space = random::<6, 3>(24..40, Spread::Narrow, 25);
    agree(&plane);
    agree(&space);
    assert_met(&[(plane.closed.same + plane.opening.same, 47), (space.closed.same + space.opening.same, 21)]);
}

/// Where numbers lie far apart the structured solver ends on fewer rays, and hardly ever on one where the dense one does not.
#[test]
fn random_scenes_of_springs_and_friction_far_apart() {
    for Tallies { closed, opening, unsettled } in
        [random::<3, 2>(2..9, Spread::Wide, 1500), random::<6, 3>(3..9, Spread::Wide, 1500)]
    {
        let sum = |of: fn(&Tally) -> usize| of(&closed) + of(&opening) + of(&unsettled);
        assert!(sum(|t| t.other_states) * 50 <= sum(|t| t.scenes));
        assert_met(&[(sum(|t| t.same), 900)]);
        assert!(sum(|t| t.only_structured) > 2 * sum(|t| t.only_dense));
    }
}

/// Contacts in a regular polygon, every second or third pressed less, the fingers moved apart or against each other: contacts that are alike reach the
/// edges of their cones together.
#[test]
fn symmetric_scenes() {
    let mut tallies = Tallies::default();
    for count in 3..13 {
        for period in 1..4 {
            for mu in [0.1, 0.3, 0.6] {
                for aside in [0.0, 0.02, 0.06] {
                    for shear in [0.0, 0.02, 0.05, 0.1] {
                        let command = |i: usize| [0.06 / (1 + i % period) as f64, aside];
                        let force = shear * count as f64;
                        let grasp = ring(count, mu, command);
                        tallies.compare(&grasp, &planar::Wrench::new([0.0, -force], 0.0));
                        tallies.compare(&grasp, &planar::Wrench::new([0.0, 0.0], force));
                        let load = spatial::Wrench::new([0.0, force, -0.1], [0.0, 0.0, 0.0]);
                        tallies.compare(&pad(count, mu, command), &load);
                    }
                }
            }
        }
    }
    agree(&tallies);
    let Tallies { closed, opening, unsettled } = tallies;
    assert!(closed.pivots + opening.pivots + unsettled.pivots > 3000);
    // Some end in another of the bases that meet in their answer: these scenes are not drawn, but rounding decides which.
    assert!(4 * unsettled.other_states <= unsettled.scenes && unsettled.only_dense == 0, "{unsettled:?}");
}

/// In the plane, normals towards the centre, all fingers moved aside the same way round.
fn ring(count: usize, mu: f64, command: impl Fn(usize) -> [f64; 2]) -> planar::Grasp {
    let contact = |i: usize| around::<2>(i, count, 1.0, [10.0, 5.0], mu).command(command(i));
    Grasp::new((0..count).map(contact)).expect("valid")
}

/// In space, all normals up, all fingers moved outwards.
fn pad(count: usize, mu: f64, command: impl Fn(usize) -> [f64; 2]) -> spatial::Grasp {
    let contact = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / count as f64).sin_cos();
        let [press, aside] = command(i);
        Contact::new([cos, sin, 0.0], [0.0, 0.0, 1.0])
            .tangent([cos, sin, 0.0])
            .series_stiffness(10.0, 5.0)
            .friction(mu)
            .command(SVector::from([press, aside, 0.0]))
    };
    Grasp::new((0..count).map(contact)).expect("valid")
}
