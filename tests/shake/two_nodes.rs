//! If slip changes the normal forces of two contacts, the initial slips decide the long-term behaviour between two limits of the load.
//!
//! In the plane of both slips, each contact has two lines, one for either direction of sliding, at the worst load of a cycle. Inside all four lines
//! nothing slides. As loads grow, the region loses a side. From this load on some initial slips lead to slip for ever, although the region exists.
//! After the region has vanished all initial slips do (Ahn, Bertocchi and Barber, Shakedown of coupled two-dimensional discrete frictional systems,
//! J. Mech. Phys. Solids 56, 2008). Lines and limits are computed here from points, springs and commands alone.

use grasp_lcp::Error;
use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
use nalgebra::{Matrix3, Vector2, Vector3};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A contact, or a spring that holds the body: point, normal, stiffness along both axes, friction, command along the normal.
#[derive(Clone, Copy)]
struct Node {
    point: Vector2<f64>,
    normal: Vector2<f64>,
    stiffness: [f64; 2],
    friction: f64,
    command: f64,
}

impl Node {
    /// Unit forces along the normal and along the tangent, with their moments.
    fn axes(&self) -> [Vector3<f64>; 2] {
        [self.normal, Vector2::new(-self.normal.y, self.normal.x)]
            .map(|axis| Vector3::new(axis.x, axis.y, self.point.perp(&axis)))
    }
}

/// A body on four contacts. The first two have friction, the last two are bonded.
struct System([Node; 4]);

impl System {
    fn draw(random: &mut Random) -> Self {
        let mut node = |x: f64, lean: f64, stiffness: f64, friction: f64, command: f64| Node {
            point: Vector2::new(x, random.between(-0.3, 0.3)),
            normal: Vector2::new(lean.sin(), lean.cos()),
            stiffness: [stiffness * random.between(0.5, 2.0), stiffness * random.between(0.5, 2.0)],
            friction,
            command: command * random.between(0.8, 1.2),
        };
        let mu = 0.3;
        Self([
            node(-1.0, 0.5, 1e3, mu, 0.02),
            node(1.0, -0.2, 1e3, mu, 0.02),
            node(-0.7, 0.0, 5e2, 0.0, 0.0),
            node(0.4, 0.0, 5e2, 0.0, 0.0),
        ])
    }

    /// Normal and tangential forces of both frictional contacts, under a load and with commands along both axes of each contact.
    fn forces(&self, load: Vector3<f64>, commands: [[f64; 2]; 4]) -> [[f64; 2]; 2] {
        let (mut stiffness, mut push) = (Matrix3::zeros(), load);
        for (node, command) in self.0.iter().zip(commands) {
            for ((axis, k), a) in node.axes().iter().zip(node.stiffness).zip(command) {
                stiffness += axis * axis.transpose() * k;
                push += axis * (k * a);
            }
        }
        let twist = stiffness.cholesky().expect("held").solve(&push);
        [0, 1].map(|i| {
            let (axes, k) = (self.0[i].axes(), self.0[i].stiffness);
            [0, 1].map(|a| k[a] * (commands[i][a] - axes[a].dot(&twist)))
        })
    }

    /// For each contact and direction of sliding the line `a + λ b + c·s`, nonnegative if the contact does not slide, at the worst load and with the slips s.
    fn lines(&self, loads: &[Vector3<f64>], times: f64) -> Vec<(f64, Vector2<f64>)> {
        let given = self.0.map(|node| [node.command, 0.0]);
        let slip = |j: usize| {
            let mut commands = [[0.0; 2]; 4];
            commands[j][1] = -1.0;
            self.forces(Vector3::zeros(), commands)
        };
        let (slips, mut lines) = ([slip(0), slip(1)], Vec::new());
        for i in 0..2 {
            for way in [1.0, -1.0] {
                let left = |force: [f64; 2]| self.0[i].friction * force[0] + way * force[1];
                let worst = loads.iter().map(|load| left(self.forces(load * times, given)[i]));
                let worst = worst.fold(f64::INFINITY, f64::min);
                lines.push((worst, Vector2::new(left(slips[0][i]), left(slips[1][i]))));
            }
        }
        lines
    }

    /// Number of sides of the region without sliding; zero if the region is empty.
    fn sides(&self, loads: &[Vector3<f64>], times: f64) -> usize {
        let lines = self.lines(loads, times);
        let has_side = |k: usize| {
            // The segment of line k that lies inside the half planes of all other lines; it is a side of the region if its length is positive.
            let (a, c) = lines[k];
            let (foot, along) = (-c * (a / c.norm_squared()), Vector2::new(-c.y, c.x));
            let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
            for (a, c) in lines.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, line)| line) {
                let (here, rate) = (a + c.dot(&foot), c.dot(&along));
                if rate > 0.0 { from = from.max(-here / rate) } else { to = to.min(-here / rate) }
            }
            from < to
        };
        (0..lines.len()).filter(|k| has_side(*k)).count()
    }

    /// The largest load factor up to which the region without sliding has at least this number of sides.
    fn limit(&self, loads: &[Vector3<f64>], sides: usize) -> f64 {
        let (mut below, mut above) = (0.0, 1.0);
        while self.sides(loads, above) >= sides && above < 1e6 {
            above *= 2.0;
        }
        for _ in 0..60 {
            let middle = 0.5 * (below + above);
            if self.sides(loads, middle) >= sides { below = middle } else { above = middle }
        }
        below
    }

    /// The grasp with these initial slips of the frictional contacts. A slip is set as an opposite command along the tangent.
    fn grasp(&self, slips: [f64; 2]) -> Result<Grasp, Error> {
        Grasp::new(self.0.iter().enumerate().map(|(i, node)| {
            let contact = Contact::new([node.point.x, node.point.y], [node.normal.x, node.normal.y])
                .series_stiffness(node.stiffness[0], node.stiffness[1]);
            if i < 2 {
                contact.friction(node.friction).command([node.command, -slips[i]])
            } else {
                contact.bonded()
            }
        }))
    }
}

/// Whether the system comes to rest, for each of several initial slips. Only slips are taken that leave both contacts within their cones without the
/// loads.
fn rests(system: &System, loads: &[Vector3<f64>], times: f64) -> Result<Vec<bool>, Error> {
    let at_rest = system.lines(&loads[..1], 0.0);
    let legs: Vec<_> = loads
        .iter()
        .flat_map(|load| Leg::there_and_back(Wrench::new([load.x, load.y], load.z) * times))
        .collect();
    let mut found = Vec::new();
    for (k, l) in (-8..=8).flat_map(|k| (-8..=8).map(move |l| (k, l))) {
        let slips = [f64::from(k), f64::from(l)].map(|part| 1e-3 * part);
        if at_rest.iter().all(|(a, c)| a + c.dot(&Vector2::from(slips)) > 0.0) {
            let shaken = system.grasp(slips)?.shake(Wrench::ZERO, &legs)?;
            found.push(shaken.rests().unwrap_or_else(|| panic!("{shaken}")));
        }
    }
    Ok(found)
}

#[test]
fn what_it_remembers_decides_between_two_limits() -> Result<(), Error> {
    let mut random = seeded(2008);
    let (mut told, mut remembered) = (0, 0);
    for _ in 0..samples(30) {
        let system = System::draw(&mut random);
        let load =
            Vector3::new(random.between(-1.0, 1.0), random.between(-0.2, 0.2), random.between(-0.3, 0.3));
        let loads = [load, -load];
        let [all, some] = [4, 3].map(|sides| system.limit(&loads, sides));
        let found = system
            .grasp([0.0; 2])?
            .statics()
            .shakedown(Wrench::ZERO, &loads.map(|load| Wrench::new([load.x, load.y], load.z)))?;
        let found = found.expect("holds at rest");
        assert!(found.slips_change_normal_forces);
        assert!((found.factor - some).abs() <= 1e-8 * some, "{} {some}", found.factor);
        // Only systems with separate limits and without opening contacts are compared.
        let given = system.0.map(|node| [node.command, 0.0]);
        let pressed = |load: Vector3<f64>| system.forces(load, given).map(|force| force[0]);
        let opens = loads.iter().any(|load| {
            pressed(load * (1.1 * some))
                .iter()
                .zip(pressed(load * 0.0))
                .any(|(now, at_rest)| *now < 0.3 * at_rest)
        });
        if opens || all <= 0.0 || some < 1.1 * all {
            continue;
        }
        told += 1;
        assert!(rests(&system, &loads, 0.99 * all)?.iter().all(|rests| *rests), "below {all}");
        assert!(rests(&system, &loads, 1.01 * some)?.iter().all(|rests| !*rests), "above {some}");
        let near = rests(&system, &loads, some - 0.1 * (some - all))?;
        remembered += usize::from(near.contains(&true) && near.contains(&false));
    }
    println!("{told} {remembered}");
    assert_met(&[(told, 2), (remembered, 1)]);
    Ok(())
}
