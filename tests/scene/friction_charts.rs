//! Charts of the friction used show every contact, or name the contacts left out. A soft fingertip is one contact.

use grasp_lcp::picture::{chart_of_load, chart_of_program, chart_of_turn};
use grasp_lcp::planar::{Contact, Grasp, Leg, Pressure, Ramp, SoftFingertip, Turn, Wrench};

use crate::LONG;
use crate::turn_charts::curves;
use support::jaws::{self, around};
use support::svg::{Failure, Shape, shapes};

fn jaw(name: &str, x: f64) -> Contact {
    jaws::jaw::<2>(x, [1000.0, 800.0], 0.5).name(name).pressed_with(10.0)
}

/// Contacts on all sides with different normal forces, so that each uses a different fraction of its friction.
fn ring(count: usize) -> Result<Grasp, grasp_lcp::Error> {
    let support = |k: usize| {
        let at = around::<2>(k, count, 0.05, [2000.0, 1500.0], 0.5).name(format!("support {k}."));
        at.pressed_with(3.0 + 0.1 * k as f64)
    };
    Grasp::new((0..count).map(support).collect::<Vec<_>>())
}

/// All text of a picture, line by line.
fn words(svg: &str) -> Result<Vec<String>, Failure> {
    let texts = shapes(svg)?.into_iter().filter(|shape| shape.tag == "text");
    Ok(texts.map(|text| text.words).collect())
}

#[test]
fn twelve_contacts_are_all_in_the_legend() -> Result<(), Failure> {
    let svg = chart_of_turn(&ring(12)?, &Turn::tilting([0.0, -5.0], [0.0, 0.0]), "A ring")?.to_svg()?;
    let words = words(&svg)?;
    for k in 0..12 {
        assert!(words.contains(&format!("support {k}.")), "{k}");
    }
    assert!(!svg.contains("Not drawn"));
    Ok(())
}

#[test]
fn of_very_many_contacts_those_that_use_least_are_named_below() -> Result<(), Failure> {
    let chart = chart_of_load(&ring(24)?, &Ramp::from(Wrench::force([2.0, -8.0])), 1.25, "A ring")?;
    let words = words(&chart.to_svg()?)?;
    let note = words.join(" ");
    assert!(note.contains("Not drawn: 8 "), "{note}");
    for k in 0..24 {
        let name = format!("support {k}.");
        assert_eq!(note.matches(&name).count(), 1, "{name}");
    }
    // Every drawn curve reaches at least as high as the curves that are left out.
    let (drawn, least) =
        (curves(&chart)?, note.split("no more than ").nth(1).and_then(|rest| rest.split(' ').next()));
    let least: f64 = least.ok_or("a number")?.parse()?;
    let most = |curve: &Vec<(f64, f64)>| curve.iter().map(|point| point.1).fold(0.0, f64::max);
    assert!(drawn.len() == 16 && drawn.iter().all(|curve| most(curve) > least - 5e-4));
    Ok(())
}

#[test]
fn contacts_without_a_curve_are_named_with_the_reason() -> Result<(), Failure> {
    let roller = Contact::new([0.0, -0.03], [0.0, 1.0]).name("roller").series_stiffness(1e3, 8e2);
    let cup = Contact::new([0.0, 0.03], [0.0, -1.0]).name("cup").series_stiffness(10.0, 10.0).bonded();
    let far = Contact::new([0.05, 0.0], [-1.0, 0.0]).name("far").series_stiffness(1e3, 8e2).friction(0.5);
    let far = far.clearance(1.0);
    let grasp = Grasp::new([jaw("left", -0.03), jaw("right", 0.03), roller, cup, far])?;
    let svg = chart_of_load(&grasp, &Ramp::from(Wrench::force([0.0, -4.0])), 2.0, "A box")?.to_svg()?;
    let note = words(&svg)?.join(" ");
    let drawn = note.split_once("Not drawn: ").ok_or("all are drawn")?.1;
    for reason in ["roller (no friction)", "cup (glued)", "far (never touches)"] {
        assert!(drawn.contains(reason), "{note}");
    }
    Ok(())
}

/// Two pads of five strips press with 10 N each and carry the weight W together. Each uses W / 2 of its friction limit of 5 N, and slides as one.
#[test]
fn a_pad_has_one_curve_that_of_its_sums() -> Result<(), Failure> {
    let pad = SoftFingertip::pad(0.02, 5, Pressure::Uniform)?;
    let pads = Grasp::new([pad.contacts(&jaw("left", -0.03))?, pad.contacts(&jaw("right", 0.03))?].concat())?;
    let chart = chart_of_load(&pads, &Ramp::from(Wrench::force([0.0, -4.0])), 3.0, "Pads")?;
    let curves = curves(&chart)?;
    assert_eq!(curves.len(), 2);
    for (factor, used) in curves.iter().flatten() {
        assert!((used - 4.0 * factor / 10.0).abs() < 1e-9, "{factor}: {used}");
    }
    let last = curves[0].last().ok_or("a point")?;
    assert!((last.0 - 2.5).abs() < 1e-9, "lost at 10 N: {last:?}");
    let svg = chart.to_svg()?;
    assert!(!svg.contains("left 0") && svg.contains("lost: left, right "));
    Ok(())
}

/// Under an additional moment some points of a pad slide first. The pad's curve ends at 1, where all points slide.
#[test]
fn a_pad_that_slides_in_part_says_that_it_begins_to() -> Result<(), Failure> {
    let pad = SoftFingertip::pad(0.02, 5, Pressure::Parabolic)?;
    let pads = Grasp::new([pad.contacts(&jaw("left", -0.03))?, pad.contacts(&jaw("right", 0.03))?].concat())?;
    let ramp = Ramp::from(Wrench::new([0.0, -4.0], 0.05));
    let chart = chart_of_load(&pads, &ramp, 3.0, "Pads")?;
    let svg = chart.to_svg()?;
    assert!(svg.contains("begins to slide"), "{:?}", words(&svg)?);
    let most = curves(&chart)?.iter().flatten().map(|point| point.1).fold(0.0, f64::max);
    assert!(most <= 1.0 + 1e-9 && most > 0.999, "{most}");
    Ok(())
}

#[test]
fn curves_that_coincide_are_both_seen() -> Result<(), Failure> {
    let jaws = Grasp::new([jaw("left", -0.03), jaw("right", 0.03)])?;
    let chart = chart_of_load(&jaws, &Ramp::from(Wrench::force([0.0, -4.0])), 2.0, "Jaws")?;
    assert_eq!(format!("{chart:?}").matches("stroke: Dashed").count(), 1);
    let aside = chart_of_load(&jaws, &Ramp::from(Wrench::force([2.0, -4.0])), 2.0, "Jaws")?;
    assert_eq!(format!("{aside:?}").matches("stroke: Dashed").count(), 0);
    Ok(())
}

/// The first leg is a load of 8 N down, and the second leg takes 6 N off. Each jaw carries half: 0.8 of its friction limit of 5 N, then 0.2.
#[test]
fn a_program_is_drawn_leg_by_leg() -> Result<(), Failure> {
    let jaws = Grasp::new([jaw("left", -0.03), jaw("right", 0.03)])?;
    let legs = [-8.0, -2.0].map(|load| Leg::load_to(Wrench::force([0.0, load])));
    let chart = chart_of_program(&jaws, Wrench::ZERO, &legs, "There and back")?;
    for (leg, used) in curves(&chart)?.into_iter().flatten() {
        let closed = if leg <= 1.0 { 0.8 * leg } else { 0.8 - 0.6 * (leg - 1.0) };
        assert!((used - closed).abs() < 1e-12, "{leg}: {used} {closed}");
    }
    Ok(())
}

#[test]
fn long_names_stay_inside() -> Result<(), Failure> {
    let long = LONG;
    let jaws = Grasp::new([jaw(&format!("{long} left"), -0.03), jaw(&format!("{long} right"), 0.03)])?;
    let svg = chart_of_load(&jaws, &Ramp::from(Wrench::force([0.0, -4.0])), 3.0, long)?.to_svg()?;
    // Vertical text is at the left edge.
    let sideways = |shape: &&Shape| shape.tag == "text" && shape.points[0][0] > 100.0;
    for text in shapes(&svg)?.iter().filter(sideways) {
        let long = 0.5 * text.size * text.words.chars().count() as f64;
        let left = text.points[0][0] - text.left * long;
        assert!(left >= 0.0 && left + long <= 4.0 * 860.0, "{text:?}");
    }
    Ok(())
}
