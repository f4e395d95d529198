//! In pictures of planar grasps the load is on its line of action, its moment turns the right way, and forces stay inside the object.

use grasp_lcp::picture::draw_grasp;
use grasp_lcp::planar::{Contact, Equilibrium, Grasp, Wrench};

use support::svg::{Failure, Shape, shapes};

const LOAD: &str = "#000000";
const FINGER: &str = "#B0B0B0";
const GREY: &str = "#6E6E6E";
const STICKING: &str = "#0072B2";
/// Widths of the arrow of a force and of the arc of a moment, pixels.
const FORCE: f64 = 3.0;
const ARC: f64 = 2.0;
/// Tolerance, pixels.
const NEAR: f64 = 0.02;

/// The shapes of a picture, and its scale and origin, found from the tips of two fingers.
struct Drawn {
    shapes: Vec<Shape>,
    origin: [f64; 2],
    metres: f64,
}

impl Drawn {
    fn new(grasp: &Grasp, state: &Equilibrium, outline: Option<&[[f64; 2]]>) -> Result<Self, Failure> {
        let shapes = shapes(&draw_grasp(grasp, state, outline, "A grasp")?)?;
        let ends: Vec<_> =
            shapes.iter().filter(|shape| shape.ink == FINGER).map(|wedge| wedge.points[0]).collect();
        let [p, q] = [0, 1].map(|i| <[f64; 2]>::from(grasp.contacts()[i].point()));
        let [a, b] = [ends[0], ends[1]];
        let metres = (q[0] - p[0]).hypot(q[1] - p[1]) / (b[0] - a[0]).hypot(b[1] - a[1]);
        // The picture is not rotated, and its pixels are counted downwards while y points up.
        let origin = [a[0] - p[0] / metres, a[1] + p[1] / metres];
        let drawn = Self { shapes, origin, metres };
        let second = drawn.point(b);
        assert!((0..2).all(|k| (second[k] - q[k]).abs() < NEAR * metres), "{second:?} {q:?}");
        Ok(drawn)
    }

    fn point(&self, place: [f64; 2]) -> [f64; 2] {
        [(place[0] - self.origin[0]) * self.metres, (self.origin[1] - place[1]) * self.metres]
    }

    /// The lines of this colour and width, in metres.
    fn lines(&self, ink: &str, width: f64) -> Vec<Vec<[f64; 2]>> {
        let is = |shape: &&Shape| shape.tag == "polyline" && shape.ink == ink && shape.width == Some(width);
        let points = |shape: &Shape| shape.points.iter().map(|place| self.point(*place)).collect();
        self.shapes.iter().filter(is).map(points).collect()
    }

    /// Tips of all arrows of this colour: the first corners of polygons.
    fn tips(&self, ink: &str) -> Vec<[f64; 2]> {
        let heads = self.shapes.iter().filter(|shape| shape.tag == "polygon" && shape.ink == ink);
        heads.map(|head| self.point(head.points[0])).collect()
    }

    fn says(&self, words: &str) -> bool {
        self.shapes.iter().any(|shape| shape.words == words)
    }
}

fn ladder() -> Result<Grasp, grasp_lcp::Error> {
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(5e5, 2e5).friction(0.4);
    let top = Contact::new([2.113, 4.532], [-1.0, 0.0]).series_stiffness(2e5, 1e5).friction(0.2);
    Grasp::new([foot.name("foot"), top.name("top")])
}

fn disk() -> Result<Grasp, grasp_lcp::Error> {
    let finger = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let at = Contact::new([cos, sin], [-cos, -sin]).series_stiffness(1e3, 8e2);
        at.friction(0.5).command([0.005, 0.0])
    };
    Grasp::new([finger(210.0), finger(330.0), finger(90.0)])
}

fn state(grasp: &Grasp, load: &Wrench) -> Result<Equilibrium, Failure> {
    Ok(grasp.solve(load)?.equilibrium().ok_or("it holds")?.clone())
}

#[test]
fn the_load_lies_on_its_line_of_action() -> Result<(), Failure> {
    let grasp = ladder()?;
    // A weight of 950 N at 1.0565 m.
    let state = state(&grasp, &Wrench::new([0.0, -950.0], -1003.675))?;
    let drawn = Drawn::new(&grasp, &state, None)?;
    let arrows = drawn.lines(LOAD, FORCE);
    assert_eq!(arrows.len(), 1);
    let tip = drawn.tips(LOAD)[0];
    for end in arrows[0].iter().chain([&tip]) {
        assert!((end[0] - 1003.675 / 950.0).abs() < NEAR * drawn.metres, "{end:?}");
    }
    // The lengths of arrows are proportional to the forces.
    let foot = state.contacts[0].force_world;
    let tips = drawn.tips(STICKING);
    let of_foot =
        tips.iter().find(|tip| (tip[0] / tip[1] - foot[0] / foot[1]).abs() < 0.01).ok_or("the foot's")?;
    let [long, short] = [arrows[0][0][1] - tip[1], of_foot[0].hypot(of_foot[1])];
    assert!((long / short - 950.0 / foot.norm()).abs() < 0.001, "{long} {short}");
    let line = drawn.shapes.iter().find(|shape| shape.dashed).ok_or("no line")?;
    assert!(line.points.iter().all(|end| (drawn.point(*end)[0] - tip[0]).abs() < NEAR * drawn.metres));
    assert!(drawn.says("load 950 N") && drawn.lines(LOAD, ARC).is_empty());
    Ok(())
}

#[test]
fn a_moment_is_an_arc_that_turns_its_way() -> Result<(), Failure> {
    let grasp = disk()?;
    for (force, moment, words) in [
        ([0.0, 0.0], 0.3, "moment 0.3 N m"),
        ([0.0, 0.0], -0.3, "moment −0.3 N m"),
        // The line of action is far from the disk, so the load is drawn at the middle of the disk, with the moment about this point.
        ([0.0, 0.1], 0.3, "moment 0.3 N m"),
        ([0.1, 0.0], -0.3, "moment −0.275 N m"),
    ] {
        let drawn = Drawn::new(&grasp, &state(&grasp, &Wrench::new(force, moment))?, None)?;
        let arcs = drawn.lines(LOAD, ARC);
        assert_eq!(arcs.len(), 1);
        assert!(drawn.says(words), "{words}");
        // The arc is around the middle between the lowest and the highest contact.
        let middle = [0.0, 0.25];
        let away: Vec<[f64; 2]> = arcs[0].iter().map(|p| [p[0] - middle[0], p[1] - middle[1]]).collect();
        let radius = away[0][0].hypot(away[0][1]);
        assert!(away.iter().all(|p| (p[0].hypot(p[1]) - radius).abs() < NEAR * drawn.metres));
        let turns: f64 =
            away.windows(2).map(|p| (p[0][0] * p[1][1] - p[0][1] * p[1][0]) / radius.powi(2)).sum();
        assert!(turns * moment > 0.0 && (3.0..5.0).contains(&turns.abs()), "{turns}");
        assert_eq!(drawn.lines(LOAD, FORCE).len(), usize::from(force != [0.0, 0.0]));
        // No dashed line of action is drawn at a wrong place.
        assert!(!drawn.shapes.iter().any(|shape| shape.ink == GREY && shape.dashed));
    }
    Ok(())
}

#[test]
fn forces_do_not_leave_through_the_back() -> Result<(), Failure> {
    // Two fingers on a tall narrow box. Arrows as long as the height of the box would pass through its other side.
    let finger = |x: f64| {
        let at = Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0);
        at.friction(0.5).command([0.01, 0.0])
    };
    let grasp = Grasp::new([finger(-0.02), finger(0.02)])?;
    let box_ = [[-0.02, -0.1], [0.02, -0.1], [0.02, 0.1], [-0.02, 0.1]];
    let drawn = Drawn::new(&grasp, &state(&grasp, &Wrench::ZERO)?, Some(&box_))?;
    let tips = drawn.tips(STICKING);
    // Each of two fingers has the polygon of a cone and that of an arrow.
    assert_eq!(tips.len(), 4);
    assert!(tips.iter().all(|tip| tip[0].abs() <= 0.02 + NEAR * drawn.metres), "{tips:?}");
    Ok(())
}
