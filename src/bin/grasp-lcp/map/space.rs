//! The map of a grasp in space. A force acts at one point. For each of its directions the map has the force at first slip and the force at which the
//! load path ends. The map is printed as a table, and drawn on the sphere of directions. The base load acts in addition to this force.

use std::time::Duration;

use grasp_lcp::picture::{SphereGrid, SphereMap};
use grasp_lcp::scene::Setup;
use grasp_lcp::spatial::{Grasp, Ramp, Wrench};
use grasp_lcp::sweep::Reserve;
use grasp_lcp::words::Words;

use super::ask::{self, FirstSlipForce};
use super::data_deviations::DataDeviations;
use super::limit::{self, FOLLOWED_TO, LimitEnd, LimitForce};
use super::rows;
use super::watch::{MOST_SWEEP_TIME, MapProgress};
use super::written::WrittenMap;
use crate::failure::Failure;
use crate::files::Pictures;

/// The grid of force directions in which load paths are followed: number of rings from pole to equator, and number of directions on a ring.
const PATH_GRID: (usize, usize) = (16, 42);
/// Time limit of the load paths in all directions of the grid together. If they take longer, the program makes no map of them.
const MOST_PATH_TIME: Duration = Duration::from_secs(120);

pub(crate) fn map(
    setup: &Setup<3>,
    at: [f64; 3],
    (data_deviations, watch): (&DataDeviations, MapProgress),
    pictures: Option<&Pictures>,
) -> Result<(), Failure> {
    let grasp = setup.grasp()?;
    let base = ask::base(setup);
    let pull = |direction: [f64; 3]| Wrench::force_at(direction, at);
    let ramp = |direction: [f64; 3]| Ramp::load(base, pull(direction));
    ask::check_base(&grasp, &ramp([0.0, 0.0, -1.0]))?;
    let quick = ask::quick(&grasp);

    // A load path takes a thousand times as long to compute as the force at first slip; the grid of load paths is therefore coarser. For grasps with
    // many contacts this coarse grid also serves for first slip.
    let (rings, around) = if grasp.len() > MOST_NAMED_POINTS { PATH_GRID } else { (45, 120) };
    let grid = SphereGrid::new(rings, around);
    let directions = grid.directions();
    let first = |d: [f64; 3]| ask::first(&quick, &ramp(d));
    let firsts =
        watch.sweep("onsets", &directions, MOST_SWEEP_TIME, |d| first(*d))?.ok_or_else(ask::too_long)?;
    let onsets: Vec<f64> = firsts.iter().map(|first| first.force).collect();
    let finite = || onsets.iter().copied().enumerate().filter(|(_, x)| x.is_finite());
    let largest = finite().map(|(_, x)| x).fold(0.0, f64::max);
    let Some((nearest, least)) = finite().min_by(|a, b| a.1.total_cmp(&b.1)).filter(|_| largest > 0.0) else {
        return Err(Failure::Scene(
            "no direction has an onset above zero: the grasp carries nothing more".to_owned(),
        ));
    };
    // The direction of the least force at first slip. It is exact if all contacts are closed and stick under the base load; otherwise it is the
    // direction of the grid in which this force is least.
    let (weakest, onset) = ask::weakest(&quick, &base, at)?.unwrap_or((directions[nearest], least));

    let coarse = SphereGrid::new(PATH_GRID.0, PATH_GRID.1);
    let most = FOLLOWED_TO * largest;
    let ways = coarse.directions();
    let reserve = grasp.reserve(base, &data_deviations.uncertainty(), data_deviations.sigmas)?;
    let reserves = watch
        .sweep("reserves", &ways, MOST_SWEEP_TIME, |d| Ok(reserve.along(&pull(*d))))?
        .ok_or_else(ask::too_long)?;
    let lasts = load_paths(&grasp, watch, base, &pull, (&ways, most))?;

    let caution = ask::caution(&grasp, &base);
    let Some(pictures) = pictures else {
        let onsets = directions.iter().copied().zip(&firsts).collect();
        let paths = ways.iter().copied().zip(lasts.iter().flatten()).collect();
        let reserves = ways.iter().copied().zip(reserves).collect();
        WrittenMap {
            at,
            base,
            data_deviations,
            onsets,
            reserves,
            paths,
            most,
            weakest: Some((weakest, onset)),
            caution,
        }
        .print();
        return Ok(());
    };
    let title = pictures.title();
    let words = ask::words(setup, at, &base, caution).join(", ");
    println!("{title}: {words}");
    print_table((&grasp, watch), (&first, &reserve), &pull, (base, most), weakest)?;
    println!("  {}", data_deviations.words().join(" "));
    let number = |x: f64| Words::default().number(x);
    println!("  onsets in {} directions: {} to {} N", directions.len(), number(least), number(largest));
    println!("  weakest direction ({}): first slip at {} N", components(weakest), number(onset));
    print_paths(&grasp, lasts.as_deref(), (ways.len(), most));
    let first = first(weakest)?;

    let drawing = Drawing { grasp: &grasp, pictures, title: &title, words: &words, data_deviations };
    let weak = format!("Weakest: {onset:.6} N along ({}), where {}.", components(weakest), first.contacts);
    drawing.of_onsets(grid, &firsts, (weakest, onset, &weak))?;
    drawing.of_reserves(coarse, reserves)?;
    match lasts.filter(|lasts| lasts.iter().any(|last| last.force.is_finite())) {
        Some(lasts) => drawing.of_limits(coarse, &lasts, most),
        None => Ok(()),
    }
}

/// For each direction in `ways`, the end of the load path along which a force in this direction grows from zero up to `most`, N. `None` if the paths
/// take longer than [`MOST_PATH_TIME`], or if the grasp has more than [`MOST_NAMED_POINTS`] contact points.
fn load_paths(
    grasp: &Grasp,
    watch: MapProgress,
    base: Wrench,
    pull: &(impl Fn([f64; 3]) -> Wrench + Sync),
    (ways, most): (&[[f64; 3]], f64),
) -> Result<Option<Vec<LimitForce>>, Failure> {
    if grasp.len() > MOST_NAMED_POINTS {
        return Ok(None);
    }
    let quick = ask::quick(grasp);
    // Enumerating combinations of contact states takes most of the time. They are enumerated only in directions in which the end of the load path is
    // otherwise unknown.
    Ok(watch.sweep("load paths", ways, MOST_PATH_TIME, |d| {
        let last = limit::last(&quick, base, pull(*d), most)?;
        let known = last.end != LimitEnd::Unknown;
        if known { Ok(last) } else { limit::last(grasp, base, pull(*d), most) }
    })?)
}

/// Prints the force up to which load paths were followed, and how many paths end in each way, such as at a limit load.
fn print_paths(grasp: &Grasp, lasts: Option<&[LimitForce]>, (ways, most): (usize, f64)) {
    match lasts {
        Some(lasts) => println!(
            "  of {ways} paths, followed to {most:.1} N with an error of a step of {:.0e}: {}",
            limit::STEP_ERROR,
            limit::count(lasts)
        ),
        None => println!(
            "  no map of what is held: load paths in {ways} directions take too long here ({} points of contact)",
            grasp.len()
        ),
    }
}

/// The grasp, the files of its pictures, and the texts that all its maps share.
struct Drawing<'a> {
    grasp: &'a Grasp,
    pictures: &'a Pictures,
    title: &'a str,
    words: &'a str,
    data_deviations: &'a DataDeviations,
}

impl Drawing<'_> {
    /// Draws and saves the map of the force at first slip in every direction.
    fn of_onsets(
        &self,
        grid: SphereGrid,
        firsts: &[FirstSlipForce],
        (weakest, onset, weak): ([f64; 3], f64, &str),
    ) -> Result<(), Failure> {
        let onsets = firsts.iter().map(|first| first.force).collect();
        let title = format!("{}: onset of sliding for a force in every direction", self.title);
        let map = SphereMap::new(title, "onset (N)", grid, onsets)?
            .mark(weakest, format!("weakest {onset:.3} N"))
            .meanings("never slides", "not known");
        self.save("_map.svg", map, weak)
    }

    /// Draws and saves the map of the force `held`, N, in every direction. Under this force uncertain data may deviate by the given number of
    /// standard deviations before a contact slides.
    fn of_reserves(&self, grid: SphereGrid, held: Vec<f64>) -> Result<(), Failure> {
        let sigmas = self.data_deviations.sigmas;
        let title = format!("{}: onset of sliding with {sigmas}σ in reserve", self.title);
        let map =
            SphereMap::new(title, "with reserve (N)", grid, held)?.meanings("never slides", "not known");
        self.save("_map_robust.svg", map, &self.data_deviations.words().join(" "))
    }

    /// Draws and saves the map of the force at which the load path in each direction ends; paths were followed up to `most`, N.
    fn of_limits(&self, grid: SphereGrid, lasts: &[LimitForce], most: f64) -> Result<(), Failure> {
        let held = lasts.iter().map(|last| last.force).collect();
        let title = format!("{}: what is held on the load path", self.title);
        let map = SphereMap::new(title, "held to (N)", grid, held)?
            .meanings(format!("held to {most:.0} N and on"), "not known");
        let ends = format!("How the {} paths end: {}.", lasts.len(), limit::count(lasts));
        self.save("_map_limit.svg", map, &ends)
    }

    /// Saves the picture of a map in a file whose name ends in `end`. Below it stand the notes that all maps share, and the note `note`. Contact
    /// normals are marked with the names of the contacts, if there are at most [`MOST_NAMED_POINTS`], 8.
    fn save(&self, end: &str, map: SphereMap, note: &str) -> Result<(), Failure> {
        let note_of_all = "Crosses: contact normals, the way the finger pushes. Equal areas are equal solid angles. \
                           Rings: angle from ±z.";
        let mut map = map.note(note_of_all).note(format!("{}.", self.words)).note(note);
        if self.grasp.len() <= MOST_NAMED_POINTS {
            for (i, (contact, frame)) in self.grasp.contacts().iter().zip(self.grasp.frames()).enumerate() {
                map = map.ray([frame[(0, 0)], frame[(1, 0)], frame[(2, 0)]], contact.label_text(i));
            }
        }
        self.pictures.save(end, &map.to_svg()?)
    }
}

/// Largest number of contact points whose names are drawn. If more names were drawn, they would cover the map. The load paths of a grasp with more
/// points take minutes.
const MOST_NAMED_POINTS: usize = 8;

fn print_table(
    (grasp, watch): (&Grasp, MapProgress),
    (first, reserve): (&impl Fn([f64; 3]) -> Result<FirstSlipForce, grasp_lcp::Error>, &Reserve<3>),
    pull: &(impl Fn([f64; 3]) -> Wrench + Sync),
    (base, most): (Wrench, f64),
    weakest: [f64; 3],
) -> Result<(), Failure> {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let back = |d: [f64; 3]| d.map(|x: f64| 0.0 - x);
    let names = ["+x", "−x", "+y", "−y", "+z", "−z", "weakest"];
    let ways = [x, back(x), y, back(y), z, back(z), weakest];
    // With many contacts, the search for a proof that no equilibrium exists beyond the end of a path takes seconds, and hardly ever succeeds.
    let quick = if grasp.len() > MOST_NAMED_POINTS { &ask::quick(grasp) } else { grasp };
    let lasts = watch
        .sweep("load paths of the table", &ways, MOST_PATH_TIME, |d| {
            limit::last(quick, base, pull(*d), most)
        })?
        .ok_or_else(ask::too_long)?;
    rows::head();
    for ((name, d), last) in names.iter().zip(ways).zip(&lasts) {
        rows::row(name, &first(d)?, reserve.along(&pull(d)), last, most);
    }
    Ok(())
}

fn components(d: [f64; 3]) -> String {
    d.map(|x| format!("{x:.4}")).join(", ")
}
