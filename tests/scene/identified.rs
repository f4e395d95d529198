//! Slips that a scene tells of: its answer is that of the grasp, and comes back as it was written.

use grasp_lcp::identify::{Identify, Slip, Unknown, UnknownKind};
use grasp_lcp::planar::{Contact, Turn, Wrench};
use grasp_lcp::scene::{
    Answer, Answers, ContactPoints, IdentifyAsked, KnownSum, Question, Scene, Setup, SlipAsked, Space,
    UnknownAsked,
};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn feet(half: f64) -> [Contact; 2] {
    [-half, half].map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 7e4).friction(0.5))
}

/// Everything that can be said: two layouts, a pull and a tilt, a sum that is known, friction of each foot, what is carried.
fn asked() -> IdentifyAsked<2> {
    let mut friction = UnknownAsked::of(UnknownKind::Friction);
    (friction.name, friction.start) = (Some("rubber".to_owned()), Some(0.4));
    let carried = |contact| {
        let mut carried = UnknownAsked::of(UnknownKind::Carried);
        carried.contacts = vec![contact];
        carried
    };
    let pull = |newtons: f64| SlipAsked::gross(Wrench::force([newtons, 0.0]));
    let mut moved = pull(3.1);
    moved.layout = Some(1);
    let mut slips = vec![pull(2.9), pull(3.0), pull(3.2), moved];
    slips.iter_mut().zip([4, 4, 1, 1]).for_each(|(slip, group)| slip.group = Some(group));
    let mut asked = IdentifyAsked::new(vec![friction, carried(0), carried(1)], slips);
    asked.layouts = vec![ContactPoints([-0.2, 0.2].map(|x| [x, 0.0].into()).into())];
    asked.known = vec![KnownSum::new([1], 4.0, 0.01), KnownSum::new([1, 2], 10.0, 0.01)];
    (asked.outliers, asked.iterations) = (Some(3.0), Some(50));
    asked
}

fn scene() -> Scene {
    let question = Question::Identify(Box::new(asked()));
    Scene::from(Space::Planar(Setup::new(feet(0.1).map(Into::into)).ask(question)))
}

#[test]
fn the_answer_is_that_of_the_grasp() -> Tested {
    let Answers::Planar(answers) = scene().answers()? else { panic!("in the plane") };
    let [Answer::Identify(told)] = &answers[..] else { panic!("{answers:?}") };
    let carried = |contact| Unknown::carried().of_contacts([contact]);
    let unknowns = [Unknown::friction().named("rubber").starting_at(0.4), carried(0), carried(1)];
    let slips = [2.9, 3.0, 3.2, 3.1].map(|newtons| Slip::gross(Wrench::force([newtons, 0.0])));
    let [a, b, c, d] = slips;
    let slips = [a.in_group(4), b.in_group(4), c.in_group(1), d.in_group(1).in_layout(1)];
    let same = Identify::new(unknowns, slips)
        .and_layouts([grasp_lcp::planar::Grasp::new(feet(0.2))?])
        .knowing([1], 4.0, 0.01)
        .knowing([1, 2], 10.0, 0.01)
        .with_outliers_beyond(3.0)
        .with_iterations(50);
    let found = same.answered_by(&grasp_lcp::planar::Grasp::new(feet(0.1))?)?;
    assert_eq!(told.identified, found);
    assert_eq!(told.says, found.to_string());
    assert!(told.says.starts_with("rubber 0.30"), "{}", told.says);
    Ok(())
}

#[test]
fn it_comes_back_as_it_was_written() -> Tested {
    let scene = scene();
    let text = serde_json::to_string(&scene)?;
    assert_eq!(Scene::from_json(text.as_bytes())?, scene);
    let Answers::Planar(answers) = scene.answers()? else { panic!("in the plane") };
    let read: Vec<Answer<2>> = serde_json::from_str(&serde_json::to_string(&answers)?)?;
    assert_eq!(read, answers);
    Ok(())
}

/// A tilt in place of a load; in short the first unknown.
#[test]
fn an_angle_at_which_it_slid() -> Tested {
    let mut slip = SlipAsked::gross(Wrench::ZERO);
    (slip.load, slip.turn) = (None, Some(Turn::tilting([0.0, -5.0], [0.0, 0.0]).up_to(0.4_f64.atan())));
    let asked = IdentifyAsked::new(vec![UnknownAsked::of(UnknownKind::Friction)], vec![slip]);
    let setup = Setup::new(feet(0.1).map(Into::into)).ask(Question::Identify(Box::new(asked)));
    let brief = &setup.brief_answers()?[0];
    assert_eq!((brief.question, brief.outcome), ("identify", "converged"));
    assert!(brief.factor.is_some_and(|mu| (mu - 0.4).abs() < 1e-7), "{brief:?}");
    Ok(())
}
