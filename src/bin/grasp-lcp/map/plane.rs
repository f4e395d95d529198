//! The map of a grasp in the plane, as a table and as a polar picture. For forces of every direction at one point it has the force at first slip, and
//! the force at which the load path ends.

use std::f64::consts::TAU;

use grasp_lcp::picture::{Polar, Stroke};
use grasp_lcp::planar::{Grasp, Ramp, Wrench};
use grasp_lcp::scene::Setup;
use grasp_lcp::words::Words;

use super::ask::{self, FirstSlipForce};
use super::data_deviations::DataDeviations;
use super::limit::{self, FOLLOWED_TO, LimitEnd, LimitForce};
use super::rows;
use super::watch::{MOST_SWEEP_TIME, MapProgress};
use super::written::WrittenMap;
use crate::failure::Failure;
use crate::files::Pictures;

/// Number of force directions in the picture; every 60th direction is in the table.
const MAP_DIRECTIONS: u32 = 1440;
/// The force under which no contact slides, even if friction, stiffness and clamping force deviate from their given values, is computed in every
/// fourth direction only. This saves time.
const RESERVE_EVERY: usize = 4;

pub(crate) fn map(
    setup: &Setup<2>,
    at: [f64; 2],
    (data_deviations, watch): (&DataDeviations, MapProgress),
    pictures: Option<&Pictures>,
) -> Result<(), Failure> {
    let grasp = setup.grasp()?;
    let base = ask::base(setup);
    let pull = |angle: f64| {
        // Quarter turns have exact sine and cosine, so that symmetric grasps have symmetric answers.
        let (sin, cos) = quarter(angle).unwrap_or_else(|| angle.sin_cos());
        Wrench::force_at([cos, sin], at)
    };
    let ramp = |angle: f64| Ramp::load(base, pull(angle));
    ask::check_base(&grasp, &ramp(0.0))?;
    let quick = ask::quick(&grasp);
    let angles: Vec<f64> =
        (0..MAP_DIRECTIONS).map(|k| TAU * f64::from(k) / f64::from(MAP_DIRECTIONS)).collect();
    let firsts = watch
        .sweep("onsets", &angles, MOST_SWEEP_TIME, |angle| ask::first(&quick, &ramp(*angle)))?
        .ok_or_else(ask::too_long)?;
    let onsets: Vec<f64> = firsts.iter().map(|first| first.force).collect();
    let largest = onsets.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
    if largest <= 0.0 {
        return Err(Failure::Scene(
            "no direction has an onset above zero: the grasp carries nothing more".to_owned(),
        ));
    }
    let reserve = grasp.reserve(base, &data_deviations.uncertainty(), data_deviations.sigmas)?;
    let kept: Vec<f64> = angles.iter().copied().step_by(RESERVE_EVERY).collect();
    let reserves = watch
        .sweep("reserves", &kept, MOST_SWEEP_TIME, |angle| Ok(reserve.along(&pull(*angle))))?
        .ok_or_else(ask::too_long)?;
    let reserves: Vec<_> = kept.into_iter().zip(reserves).collect();
    let most = FOLLOWED_TO * largest;
    let lasts = watch
        .sweep("load paths", &angles, MOST_SWEEP_TIME, |angle| limit::last(&grasp, base, pull(*angle), most))?
        .ok_or_else(ask::too_long)?;
    let weakest = ask::weakest(&quick, &base, at)?;
    let caution = ask::caution(&grasp, &base);
    let Some(pictures) = pictures else {
        let along = |angle: &f64| [pull(*angle).components()[0], pull(*angle).components()[1]];
        let onsets = angles.iter().map(along).zip(&firsts).collect();
        let paths = angles.iter().map(along).zip(&lasts).collect();
        let reserves = reserves.iter().map(|(angle, held)| (along(angle), *held)).collect();
        WrittenMap { at, base, data_deviations, onsets, reserves, paths, most, weakest, caution }.print();
        return Ok(());
    };
    let title = pictures.title();
    // A component that is due to rounding counts as zero, so that no angle of 1e-30° is printed.
    let clean = |x: f64, beside: f64| Words::default().beside(x, beside.abs());
    let weakest = weakest.map(|([x, y], size)| (clean(y, x).atan2(clean(x, y)).rem_euclid(TAU), size));

    let words = ask::words(setup, at, &base, caution);
    println!("{title}: {}", words.join(", "));
    print_table(&angles, &firsts, &reserves, &lasts, most);
    println!("  {}", data_deviations.words().join(" "));
    println!("  of {MAP_DIRECTIONS} paths: {}", limit::count(&lasts));
    if let Some((angle, size)) = weakest {
        let words = Words::default();
        println!("  weakest direction {}: first slip at {} N", words.angle(angle), words.number(size));
    }
    let drawing =
        Drawing { title: &title, grasp: &grasp, words: &words, reserve: data_deviations.words().join("\n") };
    let svg = drawing.of(&angles, &firsts, &reserves, &lasts, weakest)?;
    pictures.save("_map.svg", &svg)?;
    Ok(())
}

/// The exact (sin, cos) of a whole number of quarter turns; `None` for other angles.
fn quarter(angle: f64) -> Option<(f64, f64)> {
    let values = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)];
    values.into_iter().zip([0.0, 0.25, 0.5, 0.75]).find(|(_, turns)| angle == turns * TAU).map(|(v, _)| v)
}

fn print_table(
    angles: &[f64],
    firsts: &[FirstSlipForce],
    reserves: &[(f64, f64)],
    lasts: &[LimitForce],
    most: f64,
) {
    rows::head();
    let every = 60;
    let all = angles
        .iter()
        .zip(firsts)
        .zip(lasts)
        .step_by(every)
        .zip(reserves.iter().step_by(every / RESERVE_EVERY));
    for (((angle, first), last), (_, reserve)) in all {
        rows::row(&Words::default().angle(*angle), first, *reserve, last, most);
    }
}

/// The grasp and the texts that are drawn beside the curves.
struct Drawing<'a> {
    title: &'a str,
    grasp: &'a Grasp,
    words: &'a [String],
    reserve: String,
}

impl Drawing<'_> {
    fn of(
        &self,
        angles: &[f64],
        firsts: &[FirstSlipForce],
        reserves: &[(f64, f64)],
        lasts: &[LimitForce],
        weakest: Option<(f64, f64)>,
    ) -> Result<String, Failure> {
        let Self { title, grasp, words, reserve } = self;
        let with =
            |radii: &mut dyn Iterator<Item = f64>| angles.iter().copied().zip(radii).collect::<Vec<_>>();
        let most = |radii: &mut dyn Iterator<Item = f64>| radii.filter(|r| r.is_finite()).fold(0.0, f64::max);
        let onsets = || firsts.iter().map(|first| first.force);
        let (onset, limit) = (most(&mut onsets()), most(&mut lasts.iter().map(|last| last.force)));
        // The rim of the polar picture is at least 5 % beyond the largest force on its curves. If three times the largest force at first slip is
        // less, the rim is at least 5 % beyond that instead. Larger forces are drawn as arcs on the rim.
        let rim = onset.max(limit).min(3.0 * onset) * 1.05;
        let mut polar = Polar::new(format!("{title}: what a force in every direction does"), "N")
            .rim(rim)
            .curve("onset of sliding", with(&mut onsets()), Stroke::Line)
            .curve(reserve.as_str(), reserves.to_vec(), Stroke::Line)
            .curve("held on the load path", with(&mut lasts.iter().map(|last| last.force)), Stroke::Line);
        for (end, words) in [
            (LimitEnd::Snap, "… where it snaps: other\nequilibria exist beyond"),
            (LimitEnd::Ends, "… where others may\nexist beyond"),
            (LimitEnd::GivesWay, "… where nothing resists"),
            (LimitEnd::TooFar, "… where motions are\nno longer small"),
            (LimitEnd::Buckles, "… where it buckles"),
            (LimitEnd::TurnsOver, "… where it turns over"),
            (LimitEnd::Leaks, "… where a cup leaks"),
        ] {
            let ends = angles.iter().zip(lasts).filter(|(_, last)| last.end == end);
            let points: Vec<_> = ends.map(|(angle, last)| (*angle, last.force)).step_by(8).collect();
            if !points.is_empty() {
                polar = polar.curve(words, points, Stroke::Circles);
            }
        }
        if let Some((angle, size)) = weakest {
            polar = polar
                .mark(vec![(angle, size)], format!("weakest: {size:.6} N\nat {:.1}°", angle.to_degrees()));
        }
        for (i, (contact, frame)) in grasp.contacts().iter().zip(grasp.frames()).enumerate() {
            polar = polar.ray(frame[(1, 0)].atan2(frame[(0, 0)]), contact.label_text(i));
        }
        for line in *words {
            polar = polar.note(line);
        }
        for note in ["arc on the rim: beyond it", "arrows: contact normals,", "the way the finger pushes"] {
            polar = polar.note(note);
        }
        Ok(polar.to_svg()?)
    }
}
