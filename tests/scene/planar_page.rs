//! A page of a planar grasp needs no other file, shows its answer first, and has all pictures at one scale. Names cannot break its markup.

use grasp_lcp::picture::Page;
use grasp_lcp::planar::{Equilibrium, Grasp, Wrench};
use support::jaws::jaw;
use support::svg::{Failure, outside, shapes};

const NASTY: &str = "</script><b>\"left\" & 'right'\u{1b}";
const LOAD: &str = "#000000";

fn jaws(name: &str) -> Result<Grasp, grasp_lcp::Error> {
    let jaw = |x: f64| jaw::<2>(x, [2000.0, 1500.0], 0.5).pressed_with(8.0);
    Grasp::new([jaw(-0.04).name(name), jaw(0.04)])
}

fn under(grasp: &Grasp, load: f64) -> Result<Equilibrium, Failure> {
    Ok(grasp.solve(Wrench::force([0.0, -load]))?.equilibrium().ok_or("it holds")?.clone())
}

fn page_of(name: &str) -> Result<String, Failure> {
    let grasp = jaws(name)?;
    let verdict = grasp.hold(Wrench::force([0.0, -6.0]))?;
    let outline = [[-0.04, -0.03], [0.04, -0.03], [0.04, 0.03], [-0.04, 0.03]];
    let page = Page::new(&grasp, name)
        .outline(outline.map(|[x, y]| [x, y, 0.0]))
        .frame_of("6 N", &grasp, &under(&grasp, 6.0)?)
        .says(verdict.to_string())
        .frame_of("5 N", &grasp, &under(&grasp, 5.0)?)
        .nothing("20 N", "SLIPS OUT")
        .under(Wrench::force([0.0, -20.0]));
    Ok(page.to_html()?)
}

fn stills(page: &str) -> Vec<String> {
    let parts = page.split("<svg").skip(1);
    parts.map(|part| format!("<svg{}</svg>", part.split("</svg>").next().unwrap_or_default())).collect()
}

#[test]
fn its_answer_comes_first_and_it_needs_nothing_else() -> Result<(), Failure> {
    let page = page_of("left")?;
    for word in ["http", "src=", "<link", "@import", "url("] {
        assert!(!page.contains(word), "{word}");
    }
    let body = page.split("</h1>").nth(1).ok_or("a body")?;
    assert!(body.trim_start().starts_with("<section data-frame=\"0\">\n<p class=\"says\">HOLDS"), "{body}");
    assert!(page.contains("<p class=\"none\">SLIPS OUT</p>"));
    assert!(page.contains("<p class=\"says\">5 N</p>"));
    assert!(page.contains("name=\"viewport\"") && page.contains("id=\"step\" min=\"0\" max=\"2\""));
    // Each of three answers has a sentence, a picture and a table. Only those of the first answer are shown.
    assert_eq!(page.matches("<section").count(), 9);
    assert_eq!(page.matches("<section").count() - page.matches(" hidden>").count(), 3);
    Ok(())
}

#[test]
fn names_are_text_and_nothing_else() -> Result<(), Failure> {
    let (plain, nasty) = (page_of("left")?, page_of(NASTY)?);
    for tag in ["<script", "</script", "<b>", "<section", "<svg"] {
        assert_eq!(plain.matches(tag).count(), nasty.matches(tag).count(), "{tag}");
    }
    assert!(!nasty.contains('\u{1b}'));
    Ok(())
}

#[test]
fn its_pictures_have_one_scale() -> Result<(), Failure> {
    let stills = stills(&page_of("left")?);
    assert_eq!(stills.len(), 3);
    let mut long = Vec::new();
    for still in &stills {
        assert!(outside(still)?.is_none(), "{still}");
        let all = shapes(still)?;
        let tail =
            all.iter().find(|shape| shape.tag == "polyline" && shape.ink == LOAD && shape.width == Some(3.0));
        let head = all.iter().find(|shape| shape.tag == "polygon" && shape.ink == LOAD);
        let ([_, from], [_, to]) = (tail.ok_or("a load")?.points[0], head.ok_or("its head")?.points[0]);
        long.push(to - from);
        // The arrow of the load begins at the same place in all pictures.
        assert_eq!(
            tail.ok_or("a load")?.points[0],
            shapes(&stills[0])?
                .iter()
                .find(|s| s.tag == "polyline" && s.ink == LOAD && s.width == Some(3.0))
                .ok_or("a load")?
                .points[0]
        );
    }
    assert!((long[0] / long[1] - 1.2).abs() < 2e-3 && (long[2] / long[1] - 4.0).abs() < 2e-3, "{long:?}");
    Ok(())
}
