//! The load at which a ball slides in a robot hand, compared with a model of springs along the axes of the contacts.
//!
//! `cargo run --release -p robot-hand [rings of directions above the equator]`
//!
//! The program reads `hand.urdf`: three fingers of four joints, with the efforts of their motors. It closes the hand around a ball, as a
//! pinch and as a power grasp, and finds the onset of sliding in every direction. One model has joints with their stiffness and the
//! limits of their motors. The other has no joints but a spring along each axis of each contact, from the diagonal of the compliance
//! matrix of the first. The output also names joints whose motors stall.

mod closing;

use std::process::ExitCode;

use closing::{Ball, close, link_name, touches};
use grasp_lcp::grasp::SoftFingertip;
use grasp_lcp::nalgebra::{DMatrix, Matrix3, Point3, Vector3};
use grasp_lcp::picture::{Page, SphereGrid, SphereMap, View};
use grasp_lcp::robot::Robot;
use grasp_lcp::spatial::hand::{DriveChange, PartChange, PartLabel};
use grasp_lcp::spatial::{self, Contact, PathEnd};
use grasp_lcp::spatial::{Grasp, Leg, Ramp, Wrench};

type Failure = Box<dyn std::error::Error>;

/// Stiffness of the position controllers of the joints, from the palm outwards, N m/rad.
const STIFFNESS: [f64; 4] = [3.0, 3.0, 2.0, 1.2];
/// Normal and tangential stiffness of a pad, N/m.
const PAD: [f64; 2] = [6e3, 4e3];
const FRICTION: f64 = 0.9;
/// Commanded normal force of each contact without a load, N. The thumb has twice this force.
const SQUEEZE: f64 = 4.0;
/// Largest force up to which loads are followed, N.
const MOST: f64 = 200.0;

/// The fingers, the thumb first.
const FINGERS: [&str; 3] = ["thumb", "index", "middle"];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("{failure}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Failure> {
    let mut open = Robot::from_urdf(include_str!("../hand.urdf"))?.limited_by_effort();
    for finger in FINGERS {
        let names = joint_names(&open, finger)?;
        for (name, stiffness) in names.iter().zip(STIFFNESS) {
            open = open.joint_stiffness(name, stiffness)?;
        }
    }
    std::fs::create_dir_all("output")?;
    let ball = Ball { centre: Point3::new(0.0, 0.0, 0.122), radius: 0.035 };
    // The fingers are slightly bent, and their base joints close until the tips touch.
    let tips = closed(&open, [0.0, -0.3, 0.45, 0.35], &[1], &ball)?;
    of_grasp("A precision grasp by the tips", "tips", &tips, &ball, None)?;
    // The ball lies on the palm.
    let ball = Ball { centre: Point3::new(0.0, 0.0, 0.068), radius: 0.035 };
    let palm = Contact::new(ball.centre - Vector3::z() * ball.radius, [0.0, 0.0, 1.0])
        .name("palm")
        .series_stiffness(PAD[0], PAD[1])
        .friction(FRICTION)
        .pressed_with(SQUEEZE);
    let wrapped = closed(&open, [0.0, -0.3, 0.0, 0.0], &[1, 2, 3], &ball)?;
    of_grasp("A power grasp by all links and the palm", "power", &wrapped, &ball, Some(&palm))
}

/// Names of the joints of a finger, from the palm outwards.
fn joint_names(robot: &Robot, finger: &str) -> Result<Vec<String>, Failure> {
    Ok(robot.joints_of(&link_name(finger, 4))?.iter().map(|joint| joint.name().to_owned()).collect())
}

/// The hand with all fingers at these joint angles, rad, and then closed by `joints`, one after the other.
fn closed(open: &Robot, angles: [f64; 4], joints: &[usize], ball: &Ball) -> Result<Robot, Failure> {
    let mut robot = open.clone();
    for finger in FINGERS {
        for (name, angle) in joint_names(&robot, finger)?.iter().zip(angles) {
            robot = robot.posed(name, angle)?;
        }
        robot = close(robot, finger, joints, ball)?;
    }
    Ok(robot)
}

/// The contacts of a finger, each with the number of joints that move it: a soft fingertip, and point contacts on other links.
fn contacts(robot: &Robot, finger: &str, ball: &Ball) -> Result<Vec<(usize, Contact)>, Failure> {
    let mut all = Vec::new();
    // The thumb opposes two fingers.
    let squeeze = if finger == "thumb" { 2.0 * SQUEEZE } else { SQUEEZE };
    for touch in touches(robot, finger, ball)? {
        let contact = Contact::new(touch.point, touch.normal)
            .name(format!("{finger} link {}", touch.link))
            .series_stiffness(PAD[0], PAD[1])
            .friction(FRICTION)
            .pressed_with(squeeze);
        if touch.link == STIFFNESS.len() {
            let tip = SoftFingertip::<3>::ring(0.004, 4)?;
            all.extend(tip.contacts(&contact)?.into_iter().map(|contact| (touch.link, contact)));
        } else {
            all.push((touch.link, contact));
        }
    }
    Ok(all)
}

/// The grasp by a hand with joints.
fn with_joints(robot: &Robot, ball: &Ball, palm: Option<&Contact>) -> Result<Grasp, Failure> {
    let mut on_links: Vec<(String, Contact)> =
        palm.iter().map(|palm| ("palm".to_owned(), (*palm).clone())).collect();
    for finger in FINGERS {
        for (joints, contact) in contacts(robot, finger, ball)? {
            on_links.push((link_name(finger, joints), contact));
        }
    }
    let on_links: Vec<_> = on_links.iter().map(|(link, contact)| (link.as_str(), contact.clone())).collect();
    Ok(robot.hand(&on_links)?.grasp()?)
}

/// The grasp with the same contacts but without joints. The stiffness along each axis of a contact is the inverse of a diagonal entry of
/// its compliance. This is the compliance of the pad plus `J K⁻¹ Jᵀ`, with the Jacobian J of the contact and the joint stiffness K.
fn with_springs(
    robot: &Robot,
    ball: &Ball,
    palm: Option<&Contact>,
    grasp: &Grasp,
) -> Result<spatial::Grasp, Failure> {
    let mut all: Vec<Contact> = palm.cloned().into_iter().collect();
    let mut frames = grasp.frames().skip(all.len());
    for finger in FINGERS {
        let names = joint_names(robot, finger)?;
        let lines = names.iter().map(|name| robot.axis(name)).collect::<Result<Vec<_>, _>>()?;
        let carried = contacts(robot, finger, ball)?;
        for (link, contact) in &carried {
            let frame: &Matrix3<f64> = frames.next().ok_or("a frame for each contact")?;
            let share: f64 = carried.iter().filter(|(other, _)| other == link).map(|_| 1.0).sum();
            let at = Point3::from(contact.point());
            let jacobian = DMatrix::from_fn(3, *link, |a, j| {
                let (point, axis) = &lines[j];
                (frame.transpose() * axis.cross(&(at - point)))[a]
            });
            let springs = contact.series_stiffness_of_axes();
            let stiffness: [f64; 3] = std::array::from_fn(|a| {
                let joints: f64 = (0..*link).map(|j| jacobian[(a, j)].powi(2) / STIFFNESS[j]).sum();
                // Points of a soft fingertip act in parallel: each of n points gets n times the compliance of the joints.
                1.0 / (joints * share + 1.0 / springs[a])
            });
            all.push(contact.clone().series_stiffness_axes(stiffness));
        }
    }
    Ok(spatial::Grasp::new(all)?)
}

fn of_grasp(
    title: &str,
    name: &str,
    robot: &Robot,
    ball: &Ball,
    palm: Option<&Contact>,
) -> Result<(), Failure> {
    let grasp = with_joints(robot, ball, palm)?;
    let springs = with_springs(robot, ball, palm, &grasp)?;
    println!("{title}: {} contacts, {} joints", grasp.len(), grasp.joint_commands().len());
    let outcome = grasp.solve(Wrench::ZERO)?;
    let rest = outcome.equilibrium().ok_or("the hand does not hold the ball without a load")?;
    let carried: Vec<String> = rest.contacts.iter().map(|c| format!("{:.2}", c.normal_force())).collect();
    println!("  at rest: normal forces {} N", carried.join(" "));
    let at = ball.centre;
    let pull = |d: [f64; 3]| Wrench::force_at(d, at);
    println!(
        "  pull   slides at   {:<38} springs say       limit   motors that stall on the way",
        "what slides or stalls"
    );
    let axes = [
        ("+x", [1.0, 0.0, 0.0]),
        ("-x", [-1.0, 0.0, 0.0]),
        ("+y", [0.0, 1.0, 0.0]),
        ("-y", [0.0, -1.0, 0.0]),
        ("+z", [0.0, 0.0, 1.0]),
        ("-z", [0.0, 0.0, -1.0]),
    ];
    let (mut most_stalled, mut shown) = (0, None);
    for (label, direction) in axes {
        let ramp = Ramp::load(Wrench::ZERO, pull(direction));
        let onset = grasp.onset(&ramp)?;
        let leaves = onset.event().map_or_else(String::new, |event| {
            let contacts = event.leaving.iter().map(|leaving| leaving.contact.text());
            contacts.chain(event.drives.iter().map(|drive| drive.part.text())).collect::<Vec<_>>().join(", ")
        });
        let told = springs.onset(spatial::Wrench::force_at(direction, at))?.factor();
        let Reach { force, stalled, state } = limit(&grasp, &pull(direction))?;
        if let Some(state) = state.filter(|_| stalled.len() > most_stalled) {
            most_stalled = stalled.len();
            shown = Some((format!("a pull along {label} at its limit"), state));
        }
        let stalled: Vec<String> = stalled.iter().map(PartLabel::text).collect();
        println!(
            "  {label:<6} {:>9}   {leaves:<38} {:>11} {:>11}   {}",
            newtons(onset.factor()),
            newtons(told),
            newtons(Some(force)),
            stalled.join(", ")
        );
    }
    // If contacts slide under the squeeze alone, no onset exists to draw.
    if grasp.onset(Ramp::load(Wrench::ZERO, pull([0.0, 0.0, 1.0])))?.factor().is_some() {
        draw_map(title, name, &grasp, &springs, ball)?;
    }
    // Compares the run time of an equilibrium with joints to that of the same contacts with springs only.
    let (load, told) = (pull([0.0, 0.0, -0.5]), spatial::Wrench::force_at([0.0, 0.0, -0.5], at));
    let joints = microseconds(|| grasp.solve(load).map(drop))?;
    let alone = microseconds(|| springs.solve(told).map(drop))?;
    println!(
        "  one equilibrium: {joints:.0} µs with joints, {:.1} times that of springs alone",
        joints / alone
    );
    let mut page = Page::new(&grasp, title).frame("the squeeze alone", rest);
    for corners in circles(ball) {
        page = page.outline(corners);
    }
    // The second answer on the page is that of the pull along which most motors stall; the picture marks these.
    if let Some((label, state)) = &shown {
        page = page.frame(label, state);
    }
    let last = page.answers() - 1;
    std::fs::write(format!("output/robot_hand_{name}.html"), page.to_html()?)?;
    std::fs::write(format!("output/robot_hand_{name}_view.svg"), page.to_svg(Some(last), View::default())?)?;
    println!("  wrote output/robot_hand_{name}.html and output/robot_hand_{name}_view.svg\n");
    Ok(())
}

/// The mean run time of a call, µs, in the fastest of several repetitions.
fn microseconds(call: impl Fn() -> Result<(), grasp_lcp::Error>) -> Result<f64, Failure> {
    let mut best = f64::INFINITY;
    for _ in 0..20 {
        let start = std::time::Instant::now();
        for _ in 0..10 {
            call()?;
        }
        best = best.min(start.elapsed().as_secs_f64() / 10.0 * 1e6);
    }
    Ok(best)
}

fn newtons(factor: Option<f64>) -> String {
    match factor {
        None => "at rest".to_owned(),
        Some(f64::INFINITY) => format!("> {MOST:.0} N"),
        Some(newtons) => format!("{newtons:.2} N"),
    }
}

/// Draws the onset for a pull in every direction, and marks the directions in which the model of springs has the largest error.
fn draw_map(
    title: &str,
    name: &str,
    grasp: &Grasp,
    springs: &spatial::Grasp,
    ball: &Ball,
) -> Result<(), Failure> {
    let onset = |direction: [f64; 3]| {
        let onset = grasp.onset(Ramp::load(Wrench::ZERO, Wrench::force_at(direction, ball.centre)))?;
        let stalls = onset.event().is_some_and(|event| !event.drives.is_empty());
        Ok::<_, Failure>(onset.factor().map(|factor| (factor, stalls)))
    };
    let rings: usize = std::env::args().nth(1).map_or(Ok(16), |rings| rings.parse())?;
    let grid = SphereGrid::new(rings, 2 * rings);
    let directions = grid.directions();
    let (mut values, mut ratios, mut stalls) = (Vec::new(), Vec::new(), 0);
    for direction in &directions {
        let told = spatial::Wrench::force_at(*direction, ball.centre);
        let (with_joints, stalled) = onset(*direction)?.unwrap_or((f64::NAN, false));
        let with_springs = springs.onset(told)?.factor().unwrap_or(f64::NAN);
        stalls += usize::from(stalled);
        values.push(with_joints);
        ratios.push(with_springs / with_joints);
    }
    let best = |list: &[f64], sign: f64| {
        let finite = (0..list.len()).filter(|k| list[*k].is_finite());
        finite
            .min_by(|a, b| (sign * list[*a]).total_cmp(&(sign * list[*b])))
            .ok_or("no direction has a bound")
    };
    let (least, low, high) = (best(&values, 1.0)?, best(&ratios, 1.0)?, best(&ratios, -1.0)?);
    println!(
        "  {} directions: least onset {:.2} N; diagonal springs say {:.2} to {:.2} times as much; a motor stalls first in {stalls}",
        directions.len(),
        values[least],
        ratios[low],
        ratios[high]
    );
    let svg = SphereMap::new(format!("{title}: first slip or stall"), "N", grid, values)?
        .mark(directions[least], "weakest")
        .mark(directions[high], format!("springs say {:.1} x", ratios[high]))
        .mark(directions[low], format!("springs say {:.1} x", ratios[low]))
        .note(format!("A pull in every direction; a motor stalls first in {stalls} of {}.", directions.len()))
        .to_svg()?;
    std::fs::write(format!("output/robot_hand_{name}.svg"), svg)?;
    println!("  wrote output/robot_hand_{name}.svg");
    Ok(())
}

/// The end of the load path under a growing pull.
struct Reach {
    /// Largest pull that the hand holds, N; infinite if the hand holds [`MOST`].
    force: f64,
    /// Motors that stall before the end of the path.
    stalled: Vec<PartLabel>,
    /// Equilibrium at the end of the path.
    state: Option<spatial::Equilibrium>,
}

fn limit(grasp: &Grasp, pull: &Wrench) -> Result<Reach, Failure> {
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(*pull * MOST)])?;
    let events = path.run();
    let yields = |drive: &PartChange| (drive.what == DriveChange::Yields).then(|| drive.part.clone());
    let stalled = events.iter().flat_map(|event| event.drives.iter().filter_map(yields)).collect();
    let force = match path.end() {
        Some(PathEnd::Completed) => f64::INFINITY,
        Some(PathEnd::Lost(loss)) => loss.fraction * MOST,
        end => return Err(format!("the path cannot be followed: {end:?}").into()),
    };
    Ok(Reach { force, stalled, state: path.state() })
}

/// Circles of latitude of the ball, which draw its surface.
fn circles(ball: &Ball) -> Vec<Vec<[f64; 3]>> {
    let circle = |k: u32| {
        let (aside, up) = f64::from(20 * k + 10).to_radians().sin_cos();
        let at = |k: u32| {
            let (sin, cos) = f64::from(10 * k).to_radians().sin_cos();
            let arm = Vector3::new(aside * cos, aside * sin, up);
            (ball.centre + arm * ball.radius).into()
        };
        (0..36).map(at).collect()
    };
    (0..9).map(circle).collect()
}
