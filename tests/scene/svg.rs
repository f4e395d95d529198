//! What is drawn in an SVG, read back.

pub(crate) type Failure = Box<dyn std::error::Error>;

/// What is drawn: its tag, its colour, its corners or its middle, the width of its line.
#[derive(Debug)]
pub(crate) struct Shape {
    pub(crate) tag: String,
    pub(crate) ink: String,
    pub(crate) points: Vec<[f64; 2]>,
    pub(crate) width: Option<f64>,
    pub(crate) dashed: bool,
    /// Letters, their height, and the part of their width that is left of the place.
    pub(crate) words: String,
    pub(crate) size: f64,
    pub(crate) left: f64,
}

/// Everything but paths, in the order in which it is painted.
pub(crate) fn shapes(svg: &str) -> Result<Vec<Shape>, Failure> {
    let mut shapes = Vec::new();
    for text in svg.split('<').skip(1) {
        let value =
            |key: &str| text.split(&format!(" {key}=\"")).nth(1).and_then(|rest| rest.split('"').next());
        let number = |key: &str| value(key).map(str::parse::<f64>).transpose();
        let points = if let Some(points) = value("points") {
            pairs(points)?
        } else if let (Some(x), Some(y)) = (value("cx").or(value("x")), value("cy").or(value("y"))) {
            vec![[x.parse()?, y.parse()?]]
        } else {
            continue;
        };
        let ink = [value("fill"), value("stroke")].into_iter().flatten().find(|ink| *ink != "none");
        shapes.push(Shape {
            tag: text.split_whitespace().next().unwrap_or_default().to_owned(),
            ink: ink.unwrap_or_default().to_owned(),
            points,
            width: number("stroke-width")?,
            dashed: value("stroke-dasharray").is_some(),
            words: text.split_once('>').map_or("", |(_, words)| words).trim().to_owned(),
            size: number("font-size")?.unwrap_or(0.0),
            left: match value("text-anchor") {
                Some("end") => 1.0,
                Some("middle") => 0.5,
                _ => 0.0,
            },
        });
    }
    Ok(shapes)
}

/// Closed lines of each path.
pub(crate) fn paths(svg: &str) -> Result<Vec<Vec<Vec<[f64; 2]>>>, Failure> {
    let ways = svg.split("<path").skip(1).filter_map(|text| text.split(" d=\"M").nth(1)?.split('"').next());
    ways.map(|way| way.trim_end_matches('Z').split("ZM").map(pairs).collect()).collect()
}

fn pairs(text: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let pair = |pair: &str| -> Result<[f64; 2], Failure> {
        let (x, y) = pair.split_once(',').ok_or("a pair")?;
        Ok([x.parse()?, y.parse()?])
    };
    text.split_whitespace().map(pair).collect()
}

/// Middles of circles of a colour, in the order in which they are painted.
pub(crate) fn circles(svg: &str, ink: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let circles = shapes(svg)?.into_iter().filter(|shape| shape.tag == "circle" && shape.ink == ink);
    Ok(circles.map(|circle| circle.points[0]).collect())
}

/// Width and height in which an SVG is drawn.
pub(crate) fn view_box(svg: &str) -> Result<[f64; 2], Failure> {
    let text = svg.split("viewBox=\"0 0 ").nth(1).and_then(|rest| rest.split('"').next());
    let (wide, high) = text.ok_or("a view box")?.split_once(' ').ok_or("two numbers")?;
    Ok([wide.parse()?, high.parse()?])
}
