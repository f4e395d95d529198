//! A page of a spatial grasp needs no other file, and shows the numbers of the answer to the last bit. Names cannot break its markup.

use grasp_lcp::picture::{Page, View};
use grasp_lcp::spatial::{Bodies, Body, Contact, ContactAnswer, Equilibrium, Grasp, SoftFingertip, Wrench};
use grasp_lcp::words::printable;
use nalgebra::Vector3;
use serde_json::Value;

const NASTY: &str = "</script><script>alert(\"1 & 'x'\")</script>\u{2028}\\";

type Failure = Box<dyn std::error::Error>;

fn jar(name: &str) -> Result<Grasp, grasp_lcp::Error> {
    let finger = |name: &str, degrees: f64, height: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, height], [-cos, -sin, 0.0])
            .name(name)
            .series_stiffness(1000.0, 600.0)
            .friction(0.5)
            .command([0.004, 0.0, 0.0])
    };
    Grasp::new([finger(name, 180.0, 0.0), finger("index", 60.0, 0.01), finger("middle", -60.0, -0.01)])
}

fn page_of(name: &str) -> Result<(String, Grasp, Equilibrium), Failure> {
    let grasp = jar(name)?;
    let state = grasp.solve(Wrench::force_at([0.05, 0.1, -0.3], [0.005, 0.0, 0.0]))?;
    let state = state.equilibrium().ok_or_else(|| format!("{state:?}"))?.clone();
    let far = grasp.solve(Wrench::force([0.0, 0.0, -100.0]))?;
    let page = Page::new(&grasp, name)
        .outline([[0.03, 0.0, 0.05], [0.0, 0.03, 0.05], [-0.03, 0.0, 0.05]])
        .frame(name, &state)
        .outcome("too much", &far);
    Ok((page.to_html()?, grasp, state))
}

fn data(page: &str) -> Result<Value, Failure> {
    let start = "<script type=\"application/json\" id=\"grasp\">";
    let text = page.split(start).nth(1).and_then(|rest| rest.split("</script>").next());
    Ok(serde_json::from_str(text.ok_or("has data")?)?)
}

fn row(value: &Value) -> Vec<f64> {
    value.as_array().into_iter().flatten().filter_map(Value::as_f64).collect()
}

/// The marks of a list (things to draw, such as arrows and cones) that have this field.
fn marks<'v>(list: &'v Value, key: &str) -> Vec<&'v Value> {
    list.as_array().into_iter().flatten().filter(|mark| !mark[key].is_null()).collect()
}

/// The mark of fingertip `tip` on a layer such as "forces", with this field.
fn of_tip<'v>(list: &'v Value, key: &str, layer: &str, tip: usize) -> Option<&'v Value> {
    marks(list, key).into_iter().find(|mark| mark["layer"] == layer && mark["tip"] == tip)
}

#[test]
fn nothing_is_loaded_from_elsewhere() -> Result<(), Failure> {
    let (page, ..) = page_of("thumb")?;
    for word in ["http:", "https:", "src=", "href=", "url(", "import", "fetch("] {
        assert!(!page.contains(word), "{word}");
    }
    Ok(())
}

#[test]
fn names_are_text_and_nothing_else() -> Result<(), Failure> {
    let (plain, ..) = page_of("thumb")?;
    let (page, ..) = page_of(NASTY)?;
    for tag in ["<script", "</script", "<button", "<td", "alert("] {
        let expected = plain.matches(tag).count();
        // A name contains `alert(` as text in eight places: title, heading, sentence, canvas, button, section, row and data.
        let expected = if tag == "alert(" { 8 } else { expected };
        assert_eq!(page.matches(tag).count(), expected, "{tag}");
    }
    assert_eq!(marks(&data(&page)?["grasp"], "name")[0]["words"], printable(NASTY).as_ref());
    Ok(())
}

#[test]
fn numbers_are_those_of_the_answer() -> Result<(), Failure> {
    let (page, grasp, state) = page_of("thumb")?;
    let data = data(&page)?;
    let frame = &data["frames"][0];
    let scale = data["force"].as_f64().ok_or("a scale")?;
    for (i, (contact, answer)) in grasp.contacts().iter().zip(&state.contacts).enumerate() {
        assert_eq!(row(&data["contacts"][i]), contact.point().as_slice());
        let force = of_tip(frame, "arrow", "forces", i).ok_or("a force")?;
        assert_eq!(row(&force["arrow"]), contact.point().as_slice());
        assert_eq!(row(&force["along"]), (answer.force_world * scale).as_slice());
        // All displacements are drawn with one magnification, which is a whole number.
        let moves = of_tip(frame, "arrow", "displacements", i).ok_or("a displacement")?;
        let factor = row(&moves["along"])[0] / answer.body_core[0];
        assert_eq!(row(&moves["along"]), (answer.body_core * factor.round()).as_slice(), "{factor}");
        // The axis of a drawn cone is slightly longer than the arrow of the normal force.
        let cone = of_tip(frame, "cone", "cones", i).ok_or("a cone")?;
        let high = Vector3::from_row_slice(&row(&cone["middle"])) - contact.point();
        assert!((high.norm() - 1.15 * answer.normal_force() * scale).abs() < 1e-15);
    }
    // A force that acts at a point has one arrow, on its line of action.
    let [load] = marks(frame, "load")[..] else { return Err("one arrow".into()) };
    let [at, along] = [&load["load"], &load["along"]].map(|v| Vector3::from_row_slice(&row(v)));
    let force = Vector3::from(state.load.resultant());
    assert!((along / scale - force).norm() < 1e-15);
    assert!((at.cross(&force) - Vector3::from(state.load.moment())).norm() < 1e-15);
    // Without an equilibrium the contacts and the load are drawn without forces, and the page says why.
    let nothing = &data["frames"][1];
    assert!(marks(nothing, "arrow").is_empty() && marks(nothing, "cone").is_empty());
    assert_eq!(marks(nothing, "dot").len(), 3);
    assert!(page.contains("no equilibrium exists: "));
    Ok(())
}

#[test]
fn what_cannot_be_drawn_is_an_error() -> Result<(), Failure> {
    let (_, grasp, state) = page_of("thumb")?;
    let bad_corner = Page::new(&grasp, "x").outline([[f64::NAN, 0.0, 0.0]]).to_html();
    assert!(bad_corner.is_err_and(|error| error.to_string().contains("outline")));
    let other = Grasp::new(grasp.contacts()[..2].to_vec())?;
    let bad_count = Page::new(&other, "x").frame("a", &state).to_html();
    assert!(bad_count.is_err_and(|error| error.to_string().contains("3 contacts")));
    let mut broken = state;
    broken.contacts[0].force_world[1] = f64::INFINITY;
    assert!(Page::new(&grasp, "x").frame("a", &broken).to_html().is_err());
    Ok(())
}

/// The page fits a narrow screen: no fixed width exceeds 400 pixels, and wider parts scroll.
#[test]
fn a_narrow_screen_is_wide_enough() -> Result<(), Failure> {
    let (page, ..) = page_of("thumb")?;
    assert!(page.contains("content=\"width=device-width, initial-scale=1\">"));
    let style =
        page.split("<style>").nth(1).and_then(|rest| rest.split("</style>").next()).ok_or("a style")?;
    for rule in style.split(['{', ';']).filter(|rule| !rule.contains("max-width")) {
        let Some((property, value)) = rule.split_once(':') else { continue };
        if !["width", "min-width", "height"].contains(&property.trim()) {
            continue;
        }
        for length in value.split_whitespace() {
            let pixels = |unit: &str, each: f64| {
                length.strip_suffix(unit).and_then(|n| n.parse::<f64>().ok()).map(|n| n * each)
            };
            let wide = pixels("rem", 16.0).or(pixels("px", 1.0)).unwrap_or(0.0);
            assert!(wide <= 400.0 || property.trim() == "height", "{rule}");
        }
    }
    assert_eq!(page.matches("<table>").count(), page.matches("<div class=\"scrolls\">\n<table>").count());
    assert!(style.contains(".scrolls { overflow-x: auto; }"));
    // Touch rotates and enlarges the picture, and does not scroll the page.
    assert!(
        style.contains("touch-action: none")
            && page.contains("pointerdown")
            && page.contains("pointercancel")
    );
    Ok(())
}

/// Three pads of twelve points have three rows in the table and three entries in the data. Points are shown on request.
#[test]
fn a_pad_is_one_row_of_the_table() -> Result<(), Failure> {
    let tip = SoftFingertip::ring(0.005, 12)?;
    let pads = jar("thumb")?
        .contacts()
        .iter()
        .map(|contact| tip.contacts(contact))
        .collect::<Result<Vec<_>, _>>()?;
    let grasp = Grasp::new(pads.concat())?;
    let state = grasp.solve(Wrench::force([0.05, 0.1, -0.3]))?.equilibrium().cloned().ok_or("it holds")?;
    let page = Page::new(&grasp, "A jar").frame("held", &state).to_html()?;
    assert_eq!(page.matches("<tr data-contact=\"").count(), 3 + 36);
    assert_eq!(page.matches(" class=\"point\"").count(), 36);
    assert!(
        page.contains("<th>thumb</th>")
            && page.contains("<th>thumb 11</th>")
            && page.contains("id=\"points\"")
    );
    let data = data(&page)?;
    assert_eq!(data["contacts"].as_array().map(Vec::len), Some(3));
    // The row of a pad has the sum of its normal forces.
    let pressed: f64 = state.contacts[..12].iter().map(ContactAnswer::normal_force).sum();
    let row =
        page.split("<th>thumb</th>").nth(1).and_then(|rest| rest.split("</tr>").next()).ok_or("a row")?;
    let first: f64 =
        row.split("<td>").nth(1).and_then(|rest| rest.split('<').next()).ok_or("a number")?.parse()?;
    assert!((first - pressed).abs() < 1e-4 * pressed, "{first} {pressed}");
    // The third number is the moment about the normal that the forces of the pad's points have. The last number is the mean displacement of the
    // points, in mm.
    let cells: Vec<f64> = row
        .split("<td>")
        .skip(1)
        .filter_map(|cell| cell.split('<').next()?.replace('−', "-").parse().ok())
        .collect();
    assert_eq!(cells.len(), 8, "{row}");
    let points = || grasp.contacts()[..12].iter().zip(&state.contacts[..12]);
    let middle = points().map(|(contact, _)| contact.point() / 12.0).sum::<nalgebra::Vector3<f64>>();
    let about: nalgebra::Vector3<f64> =
        points().map(|(contact, answer)| (contact.point() - middle).cross(&answer.force_world)).sum();
    let moment = about.dot(&grasp.frames().next().ok_or("a frame")?.column(0));
    assert!((cells[2] - moment).abs() < 1e-4 * moment.abs().max(1e-4), "{} {moment}", cells[2]);
    let moves =
        1e3 * points().map(|(_, answer)| answer.body_core / 12.0).sum::<nalgebra::Vector3<f64>>().norm();
    assert!((cells[7] - moves).abs() < 1e-3 * moves, "{} {moves}", cells[7]);
    Ok(())
}

/// The page shows the motion by which the object is lost, the sentence of the answer, and cones with the friction of the answer.
#[test]
fn what_an_answer_has_besides_is_on_the_page() -> Result<(), Failure> {
    let grasp = jar("thumb")?;
    let verdict = grasp.hold(Wrench::force([0.0, 0.0, -30.0]))?;
    let lost = verdict.lost.clone().ok_or("it is lost")?;
    let state = lost.state.as_deref().ok_or("somewhere")?;
    let slippery = grasp.with_friction(|_, mu| 0.25 * mu)?;
    let page = Page::new(&grasp, "A jar")
        .outline([[0.03, 0.0, 0.05], [0.0, 0.03, 0.05], [-0.03, 0.0, 0.05]])
        .frame("lost", state)
        .says(verdict.to_string())
        .maybe_leaving(lost.motion.as_ref())
        .frame_of("slippery", &slippery, state);
    let html = page.to_html()?;
    assert!(["SLIPS", "TURNS"].iter().any(|out| html.contains(&format!("\"says\">{out} OUT"))), "{verdict}");
    let data = data(&html)?;
    let on_the_way = |key| marks(&data["frames"][0], key).into_iter().find(|mark| mark["layer"] == "leaves");
    let arrow = on_the_way("arrow").ok_or("an arrow")?;
    let motion = lost.motion.ok_or("a motion")?;
    let v = motion.object.components();
    let (at, along) = (row(&arrow["arrow"]), row(&arrow["along"]));
    let speed = [
        v[0] + v[4] * at[2] - v[5] * at[1],
        v[1] + v[5] * at[0] - v[3] * at[2],
        v[2] + v[3] * at[1] - v[4] * at[0],
    ];
    let dot: f64 = along.iter().zip(&speed).map(|(a, b)| a * b).sum();
    let size = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!(dot > 0.9 * size(&along) * size(&speed), "{along:?} {speed:?}");
    let slope = |frame: usize| {
        let cone = of_tip(&data["frames"][frame], "cone", "cones", 0)?;
        let [apex, middle, radius] = [&cone["cone"], &cone["middle"], &cone["radii"][0]].map(row);
        let high: Vec<f64> = middle.iter().zip(&apex).map(|(a, b)| a - b).collect();
        Some(size(&radius) / size(&high))
    };
    let [given, slippery] = [slope(0).ok_or("a cone")?, slope(1).ok_or("a cone")?];
    assert!((given - 0.5).abs() < 1e-14 && (slippery - 0.125).abs() < 1e-14, "{given} {slippery}");
    Ok(())
}

/// With several bodies each outline has the motion of its body, also in the motion by which the grasp is lost.
#[test]
fn bodies_move_on_their_own() -> Result<(), Failure> {
    let face = |height: f64, friction: f64| {
        [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]].map(|[x, y]| {
            let point = Contact::new([x, y, height], [0.0, 0.0, 1.0]);
            point.series_stiffness(1e5, 1e5).friction(friction)
        })
    };
    let weight = |newtons: f64, height: f64| Wrench::force_at([0.0, 0.0, -newtons], [0.0, 0.0, height]);
    let grasp =
        Bodies::new([Body::new("lower").load(weight(20.0, 0.1)), Body::new("upper").load(weight(10.0, 0.3))])
            .contacts(face(0.0, 0.5).map(|contact| contact.on("lower")))
            .contacts(face(0.2, 0.3).map(|contact| contact.on("upper").against("lower")))
            .loaded("upper")
            .grasp()?;
    let pull = Wrench::force_at([5.0, 0.0, 0.0], [0.0, 0.0, 0.2]);
    let verdict = grasp.hold(pull)?;
    let lost = verdict.lost.ok_or("slides")?;
    assert!((lost.factor - 0.6).abs() < 1e-9, "{}", lost.factor);
    let state = *lost.state.ok_or("stands there")?;
    let square = |height: f64| [[-0.1, -0.1, height], [0.1, -0.1, height], [0.1, 0.1, height]];
    let page = Page::new(&grasp, "two boxes")
        .body_outline(0, square(0.1))
        .body_outline(1, square(0.3))
        .body_outline(1, square(0.4))
        .frame("lost", &state)
        .maybe_leaving(lost.motion.as_ref());
    let frame = &data(&page.to_html()?)?["frames"][0];
    let lines = |layer: &str| -> Vec<Vec<Vec<f64>>> {
        let lines = marks(frame, "line").into_iter().filter(|mark| mark["layer"] == layer);
        lines.map(|mark| mark["line"].as_array().into_iter().flatten().map(row).collect()).collect()
    };
    // Each outline moves with the twist of its body, with one magnification for all.
    let moved = lines("displacements");
    let shift = |line: usize, height: f64| {
        let corner = [-0.1, -0.1, height];
        let body = &state.bodies[[0, 1, 1][line]];
        let exact = Vector3::from(body.twist.displacement_at(corner));
        (Vector3::from_row_slice(&moved[line][0]) - Vector3::from(corner), exact)
    };
    let (drawn, exact) = shift(0, 0.1);
    let factor = drawn.norm() / exact.norm();
    for (line, height) in [(0, 0.1), (1, 0.3), (2, 0.4)] {
        let (drawn, exact) = shift(line, height);
        assert!((drawn - exact * factor).norm() < 1e-12, "{line}: {drawn} {exact}");
    }
    // At the loss the upper body slides away along x, and the lower body stays.
    let leaves = lines("leaves");
    let moved = |line: usize| leaves[line][0][0] + 0.1;
    assert!(moved(0).abs() < 1e-9 && moved(1) > 0.01, "{} {}", moved(0), moved(1));
    page.to_svg(Some(0), View::default())?;
    Ok(())
}
