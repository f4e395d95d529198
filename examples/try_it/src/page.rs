//! Assembles the page: a single file with style, scripts, scenes and module.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::GzEncoder;

use crate::base64::base64;

const FRAME: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/style.css");

/// Scripts in the order in which the page runs them. Each declares one name, which later scripts may use.
const SCRIPTS: [&str; 14] = [
    include_str!("../page/numbers.js"),
    include_str!("../page/outline.js"),
    include_str!("../page/scenes.js"),
    include_str!("../page/state.js"),
    include_str!("../page/asking.js"),
    include_str!("../page/answers.js"),
    include_str!("../page/words.js"),
    include_str!("../page/svg.js"),
    include_str!("../page/view.js"),
    include_str!("../page/picture.js"),
    include_str!("../page/handles.js"),
    include_str!("../page/loadline.js"),
    include_str!("../page/told.js"),
    include_str!("../page/controls.js"),
];
const MAIN: &str = include_str!("../page/main.js");

/// Files of scenes, by their names in `scenes.js`.
const SCENES: [(&str, &str); 6] = [
    ("box", include_str!("../../scenes/box.json")),
    ("paper_two_fingers", include_str!("../../scenes/paper_two_fingers.json")),
    ("paper_disk", include_str!("../../scenes/paper_disk.json")),
    ("wedge", include_str!("../scenes/wedge.json")),
    ("pentagon", include_str!("../scenes/pentagon.json")),
    ("two_parts", include_str!("../scenes/two_parts.json")),
];

/// The HTML page, which contains the WebAssembly module.
pub(crate) fn page(module: &[u8]) -> io::Result<String> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(module)?;
    let module = base64(&packed.finish()?);
    let scenes = SCENES.map(|(name, file)| format!("\"{name}\": {file}")).join(",\n");
    let script = [SCRIPTS.concat().as_str(), MAIN].concat();
    Ok(FRAME
        .replace("{{STYLE}}", STYLE)
        .replace("{{SCENES}}", &format!("{{{scenes}}}"))
        .replace("{{SCRIPT}}", &script)
        .replace("{{MODULE}}", &module))
}
