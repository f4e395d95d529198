//! Tests the page in a browser: after drags it shows the same numbers, to the bit, as the crate answers natively.
//!
//! The test is skipped with a message without Chromium, or if the toolchain lacks WebAssembly.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

/// Script that the test appends to the page.
const DRAGS: &str = include_str!("drags.js");
/// Virtual time of the browser, ms, within which module and drags must finish. This clock skips idle time.
const VIRTUAL_TIME: u32 = 60_000;

/// The page, built as in the README; `None` without WebAssembly.
fn page() -> Option<String> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("try_it.html");
    let built = Command::new(env!("CARGO_BIN_EXE_try-it")).arg(&path).status().unwrap();
    if built.code() == Some(2) {
        println!("skipped: no WebAssembly");
        return None;
    }
    assert!(built.success());
    Some(fs::read_to_string(path).unwrap())
}

fn chromium() -> Option<PathBuf> {
    let places: Vec<_> = env::split_paths(&env::var_os("PATH")?).collect();
    let names = ["chromium", "chromium-browser", "google-chrome"];
    names.iter().flat_map(|name| places.iter().map(move |place| place.join(name))).find(|path| path.is_file())
}

/// Runs the appended script on a page `wide` pixels wide, and returns its records.
fn records(chromium: &Path, page: &str, wide: u32) -> Value {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = directory.join("dragged.html");
    // A browser window has a least width; a frame in it may be narrower. At its end the script in the frame copies its records to the outer page.
    let hands_over = "parent.document.body.append(document.getElementById('records').cloneNode(true))";
    let inner = page.replace("</body>", &format!("<script>{DRAGS}</script>\n</body>"));
    let inner =
        inner.replace("document.body.append(told);", &format!("document.body.append(told); {hands_over};"));
    let inner = inner.replace('&', "&amp;").replace('"', "&quot;");
    let frame = format!(
        "<body style=\"margin: 0\"><iframe srcdoc=\"{inner}\" style=\"border: 0; width: {wide}px; height: 1600px\"></iframe>"
    );
    fs::write(&path, format!("<!DOCTYPE html>{frame}")).unwrap();
    let run = Command::new(chromium)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--window-size=1200,1700", "--dump-dom"])
        .arg(format!("--virtual-time-budget={VIRTUAL_TIME}"))
        .arg(format!("--user-data-dir={}", directory.join("chromium").display()))
        .arg(format!("file://{}", path.display()))
        .output()
        .unwrap();
    let dom = String::from_utf8(run.stdout).unwrap();
    let begin = "<script type=\"application/json\" id=\"records\">";
    let told = dom.rsplit_once(begin).expect("the drags came to their end").1;
    serde_json::from_str(told.split_once("</script>").unwrap().0).unwrap()
}

/// Native answers of the crate to the scene of a record.
struct Native {
    onset: Value,
    solve: Value,
    follow: Value,
}

fn native(record: &Value) -> Native {
    let reply: Value =
        serde_json::from_str(&try_it::reply(record["scene"].as_str().unwrap().as_bytes())).unwrap();
    let answer = |k: usize, name: &str| reply["answers"][k][name].clone();
    Native { onset: answer(0, "onset"), solve: answer(1, "solve"), follow: answer(2, "follow") }
}

/// The number that the page shows under a name; `None` without one.
fn shown(record: &Value, what: &str) -> Option<f64> {
    record["shown"][what]["value"].as_str().map(|text| text.parse().unwrap())
}

/// Compares all numbers of a record to the bit, and returns their count.
fn compare(record: &Value) -> usize {
    let Native { onset, solve, follow } = native(record);
    let mut expected = Vec::new();
    if ["at", "gives_way"].contains(&onset["outcome"].as_str().unwrap()) {
        expected.push(("onset".to_owned(), onset["factor"].as_f64().unwrap()));
    }
    if follow["outcome"] == "lost" {
        expected.push(("limit".to_owned(), follow["fraction"].as_f64().unwrap() * 1000.0));
    }
    let no_contacts = Vec::new();
    let contacts = solve["contacts"].as_array().unwrap_or(&no_contacts);
    for (k, contact) in contacts.iter().enumerate() {
        let open = contact["state"] == "separated";
        expected.push((format!("normal-{k}"), contact["force"][0].as_f64().unwrap()));
        expected.push((format!("tangential-{k}"), contact["force"][1].as_f64().unwrap()));
        expected.push((format!("margin-{k}"), contact["margin"].as_f64().unwrap()));
        let (name, way) = if open { ("gap", &contact["gap"]) } else { ("slip", &contact["slip"][1]) };
        expected.push((format!("{name}-{k}"), way.as_f64().unwrap()));
    }
    let of_object = [(String::new(), &solve["twist"])];
    let of_bodies = solve["bodies"].as_array().into_iter().flatten().enumerate();
    let of_bodies: Vec<_> = of_bodies.map(|(k, body)| (format!("-{k}"), &body["twist"])).collect();
    let moves = if of_bodies.is_empty() { &of_object[..] } else { &of_bodies[..] };
    for (of, twist) in moves.iter().filter(|_| !contacts.is_empty()) {
        expected.push((format!("x{of}"), twist["translation"][0].as_f64().unwrap()));
        expected.push((format!("y{of}"), twist["translation"][1].as_f64().unwrap()));
        expected.push((format!("turn{of}"), twist["rotation"].as_f64().unwrap()));
    }
    for (what, value) in &expected {
        // The page writes -0 as 0.
        assert_eq!(shown(record, what).map(|x| x + 0.0), Some(value + 0.0), "{}: {what}", record["what"]);
    }
    assert_eq!(record["shown"].as_object().unwrap().len(), expected.len(), "{}", record["what"]);
    let states: Vec<_> = contacts.iter().map(|contact| contact["state"].as_str().unwrap()).collect();
    let told: Vec<_> =
        record["states"].as_array().unwrap().iter().map(|state| state.as_str().unwrap()).collect();
    let words = |state: &&str| match *state {
        "sticking" => "sticks",
        "sliding" => "slides",
        "separated" => "open",
        "frictionless" => "slides freely",
        other => panic!("{other}"),
    };
    assert_eq!(told, states.iter().map(words).collect::<Vec<_>>(), "{}", record["what"]);
    expected.len()
}

#[test]
fn the_page_shows_what_the_crate_answers() {
    let Some(chromium) = chromium() else {
        println!("skipped: no Chromium");
        return;
    };
    let Some(page) = page() else { return };
    // At the width of a phone, too, the fingers can be dragged and the page does not scroll sideways.
    for wide in [400, 1200] {
        shows_what_the_crate_answers(&records(&chromium, &page, wide), wide);
    }
    println!("page of {:.2} MB", page.len() as f64 / 1e6);
}

fn shows_what_the_crate_answers(dragged: &Value, wide: u32) {
    assert!(dragged["wide"].as_u64().unwrap() <= u64::from(wide), "{} of {wide} pixels", dragged["wide"]);
    assert!(dragged["smallest"].as_f64().unwrap() >= 20.0, "an arrow of {} pixels", dragged["smallest"]);
    assert_eq!(dragged["overlap"], false);
    let records = dragged["records"].as_array().unwrap();
    let of = |what: &str| records.iter().find(|record| record["what"] == what).unwrap();

    let numbers: usize = records.iter().map(compare).sum();
    println!("{} states of the page, {numbers} numbers equal to the bit", records.len());

    // Closed forms of the onset of sliding: of the paper's two fingers, and of two fingers with friction 0.5 that press with 8 N each.
    let paper = shown(of("paper_two_fingers"), "onset").unwrap() * 0.12;
    assert!((paper - 65f64.sqrt() / 66.0).abs() < 1e-15, "{paper}");
    let before = shown(of("box"), "onset").unwrap();
    assert!((before * 4.905 - 8.0).abs() < 1e-14, "{before}");

    // A dragged finger changes the scene and its onset. Each further action changes the scene.
    assert_ne!(shown(of("a finger dragged"), "onset"), Some(before));
    let steps = [
        "box",
        "a finger dragged",
        "a finger moved by a key",
        "the load turned",
        "the load moved",
        "sliders",
        "a finger more",
    ];
    for pair in steps.windows(2) {
        assert_ne!(of(pair[0])["scene"], of(pair[1])["scene"], "{pair:?}");
    }

    // Without an equilibrium the page shows words, but no numbers or arrows of forces.
    for what in ["no friction", "wedge"] {
        let record = of(what);
        assert_eq!(native(record).solve["outcome"], "no_equilibrium", "{what}");
        assert_eq!(record["verdict"], "No equilibrium under this load.");
        assert_eq!(record["arrows"], 0);
        assert!(record["why"].as_str().unwrap().len() > 20, "{what}");
        assert!(shown(record, "normal-0").is_none());
    }
    assert_eq!(native(of("the wedge with friction")).solve["outcome"], "equilibrium");
    // With two parts, each part has its motion, and each contact between them has two arrows.
    let parts = of("two_parts");
    assert!(shown(parts, "x-1").is_some() && shown(parts, "x").is_none());
    assert_eq!(parts["arrows"], 2 + 2 * 2);
    assert_ne!(shown(parts, "onset"), shown(of("a part of two held lower"), "onset"));
}
