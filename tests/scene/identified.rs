//! A scene can list observed slips. Its answer equals the answer of the grasp, and reads back as it was written.

use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::planar::{Contact, Turn, Wrench};
use grasp_lcp::scene::{Answer, Question, Scene, Setup};

type Tested = Result<(), Box<dyn std::error::Error>>;

fn feet(half: f64) -> [Contact; 2] {
    [-half, half].map(|x| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, 7e4).friction(0.5))
}

/// A question with all fields: two layouts, a pull and a tilt, a known sum, friction of each foot, and loads of supports.
fn asked() -> Identify<2> {
    let carried = |contact| Unknown::carried().of_contacts([contact]);
    let unknowns = [Unknown::friction().named("rubber").starting_at(0.4), carried(0), carried(1)];
    let slips = [2.9, 3.0, 3.2, 3.1].map(|newtons| Slip::gross(Wrench::force([newtons, 0.0])));
    let [a, b, c, d] = slips;
    let slips = [a.in_group(4), b.in_group(4), c.in_group(1), d.in_group(1).in_layout(1)];
    Identify::new(unknowns, slips)
        .knowing([1], 4.0, 0.01)
        .knowing([1, 2], 10.0, 0.01)
        .with_outliers_beyond(3.0)
        .with_iterations(50)
}

fn scene() -> Scene {
    let question = Question::Identify(Box::new(asked().with_points([-0.2, 0.2].map(|x| [x, 0.0]))));
    Scene::from(Setup::new(feet(0.1).map(Into::into)).ask(question))
}

#[test]
fn the_answer_is_that_of_the_grasp() -> Tested {
    let Some(answers) = scene().answers()?.planar() else { panic!("in the plane") };
    let [Answer::Identify(told)] = &answers[..] else { panic!("{answers:?}") };
    let same = asked().and_layouts([grasp_lcp::planar::Grasp::new(feet(0.2))?]);
    let found = grasp_lcp::planar::Grasp::new(feet(0.1))?.identify(&same)?;
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
    let Some(answers) = scene.answers()?.planar() else { panic!("in the plane") };
    let read: Vec<Answer<2>> = serde_json::from_str(&serde_json::to_string(&answers)?)?;
    assert_eq!(read, answers);
    Ok(())
}

/// A slip may have a tilt in place of a load. The short answer has the first unknown.
#[test]
fn an_angle_at_which_it_slid() -> Tested {
    let turn = Turn::tilting([0.0, -5.0], [0.0, 0.0]).up_to(0.4_f64.atan());
    let asked = Identify::new([Unknown::friction()], [Slip::gross_on_turn(turn)]);
    let setup = Setup::new(feet(0.1).map(Into::into)).ask(Question::Identify(Box::new(asked)));
    let brief = &setup.brief_answers()?[0];
    assert_eq!((brief.question, brief.outcome), ("identify", "converged"));
    assert!(brief.factor.is_some_and(|mu| (mu - 0.4).abs() < 1e-7), "{brief:?}");
    Ok(())
}
