//! Families of scenes, everyday and unusual, from the generators of the tests.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Leg;
use grasp_lcp::{planar, spatial};
use support::cards::HouseOfCards;
use support::odd_paths::{self, IN_SPACE, OddPath};
use support::random::{Spread, drawn, scene};
use support::scene::Scene;
use support::splitmix::Random;
use support::stacks::stack;
use support::{loaded, patches, piles, shaken, soft_tips, spatial_piles};

type Failure = Box<dyn std::error::Error>;

/// Callback that receives the name of a family and a function that answers a question about one of its scenes, in words.
type Ask<'a> = dyn FnMut(&'static str, &dyn Fn() -> Result<String, Failure>) -> Result<(), Failure> + 'a;

/// Asks about `each` scenes of each family, and about fewer scenes of families with many contacts.
pub(crate) fn ask_all(each: usize, ask: &mut Ask<'_>) -> Result<(), Failure> {
    for spread in [Spread::Narrow, Spread::Wide, Spread::Stiff] {
        for drawn in drawn(each, &scene::<3, 2>(1..9, spread, 1.0)) {
            in_units("planar contacts", &drawn, ask)?;
        }
        for drawn in drawn(each, &scene::<6, 3>(2..7, spread, 1.0)) {
            in_units("spatial contacts", &drawn, ask)?;
        }
        for drawn in drawn(each / 10, &scene::<6, 3>(32..80, spread, 1.0)) {
            in_units("spatial, 32 to 80 contacts", &drawn, ask)?;
        }
    }
    let mut random = Random(1);
    for _ in 0..each {
        followed("odd paths in the plane", &odd_paths::in_the_plane(&mut random)?, ask)?;
        for odd in IN_SPACE {
            followed("odd paths in space", &odd_paths::in_space(odd, &mut random)?, ask)?;
        }
        let cycle = shaken::in_the_plane(&mut random)?;
        ask("shaken", &|| path(&cycle.grasp, &cycle.base, &cycle.legs))?;
        let cycle = shaken::in_space(&mut random)?;
        ask("shaken", &|| path(&cycle.grasp, &cycle.base, &cycle.legs))?;
        let fingers = loaded::random_fingers(3 + random.index(0, 3), &mut random);
        let grasp = Grasp::new(fingers.contacts.clone())?;
        for part in [0.5, 2.0, 8.0] {
            let load = fingers.base + fingers.direction * part;
            ask("fingers on a ball", &|| solved(&grasp, &load))?;
            ask("fingers on a ball", &|| held(&grasp, load))?;
        }
        let (grasp, load) = soft_tips::draw(&mut random)?;
        for part in [1.0, 5.0, 40.0] {
            ask("soft fingertips", &|| solved(&grasp, &(load * part)))?;
        }
    }
    for (count, fingers) in [(2, false), (3, true), (5, false), (5, true), (12, false), (12, true)] {
        for pile in (0..each / 4).filter_map(|_| piles::boxes(&mut random, count, fingers)) {
            let grasp = pile.bodies.grasp()?;
            ask("boxes", &|| held(&grasp, pile.load))?;
            ask("boxes", &|| solved(&grasp, &pile.load))?;
        }
    }
    for bodies in 1..4 {
        for pile in drawn(each / 4, &stack::<3, 2>(bodies)) {
            let grasp = pile.grasp(bodies - 1);
            ask("bodies in the plane", &|| held(&grasp, Wrench::from_components(pile.loads[0].as_slice())))?;
        }
        for pile in drawn(each / 4, &stack::<6, 3>(bodies)) {
            let grasp = pile.grasp(bodies - 1);
            ask("bodies in space", &|| held(&grasp, Wrench::from_components(pile.loads[0].as_slice())))?;
        }
    }
    many(each, ask)
}

/// Scenes with many contacts, and with many bodies.
fn many(each: usize, ask: &mut Ask<'_>) -> Result<(), Failure> {
    for count in [8, 16, 40, 150, 1000].into_iter().filter(|count| *count <= 10 * each) {
        for part in [0.3, 1.0, 1.2] {
            let (pad, load) = patches::planar_patch(count)?;
            ask("pads", &|| solved(&pad, &(load * part)))?;
            let (pad, load) = patches::spatial_patch(count)?;
            ask("pads", &|| solved(&pad, &(load * part)))?;
            let (pad, load) = patches::fingers(count)?;
            ask("pads", &|| solved(&pad, &(load * part)))?;
        }
    }
    for rows in [3, 5, 8] {
        let (wall, spatial, cards) = (
            piles::wall(rows).grasp()?,
            spatial_piles::spatial_wall(rows.min(6)).grasp()?,
            HouseOfCards::of(rows),
        );
        let top = 0.5 * rows as f64 - 0.1;
        for push in [5.0, 60.0, 400.0] {
            let load = planar::Wrench::force_at([push, 0.0], [0.5, top]);
            ask("walls", &|| solved(&wall, &load))?;
            let load = spatial::Wrench::force_at([push, 0.1 * push, 0.0], [0.5, 0.0, top]);
            ask("walls", &|| solved(&spatial, &load))?;
        }
        for friction in [0.2, 0.5] {
            let grasp = cards.bodies(friction).grasp()?;
            ask("houses of cards", &|| solved(&grasp, &Wrench::ZERO))?;
        }
    }
    for count in [10, 40, 120].into_iter().filter(|count| *count <= each) {
        let books = piles::books(count).grasp()?;
        for pull in [5.0, 200.0] {
            ask("books", &|| solved(&books, &planar::Wrench::force([0.0, -pull])))?;
        }
    }
    Ok(())
}

/// Asks for equilibria on the round cone and on polygons; with few contacts also for the verdict on a growing load.
fn in_units<const D: usize, const C: usize>(
    name: &'static str,
    scene: &Scene<D, C>,
    ask: &mut Ask<'_>,
) -> Result<(), Failure> {
    let (grasp, load) = (scene.grasp(), scene.wrench());
    ask(name, &|| solved(&grasp, &load))?;
    if C == 3 {
        let polygon = scene.grasp().with(&Settings::default().on_the_polygon());
        ask("on polygons", &|| solved(&polygon, &load))?;
    }
    if scene.contacts.len() < 32 { ask(name, &|| held(&grasp, load)) } else { Ok(()) }
}

fn followed<const C: usize>(name: &'static str, odd: &OddPath<C>, ask: &mut Ask<'_>) -> Result<(), Failure> {
    ask(name, &|| path(&odd.grasp, &odd.start, &odd.legs))
}

fn solved<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> Result<String, Failure> {
    Ok(grasp.solve(load)?.to_string())
}

fn held<const C: usize>(grasp: &Grasp<C>, load: Wrench<C>) -> Result<String, Failure> {
    Ok(grasp.hold(load)?.to_string())
}

fn path<const C: usize>(grasp: &Grasp<C>, start: &Wrench<C>, legs: &[Leg<C>]) -> Result<String, Failure> {
    let mut path = grasp.follow(start, legs)?;
    let events = path.by_ref().count();
    Ok(format!("{events} events, {:?}", path.end()))
}
