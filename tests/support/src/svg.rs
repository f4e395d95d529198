//! Reads shapes of an SVG back for tests.

/// Why a picture could not be read.
pub type Failure = Box<dyn std::error::Error>;

/// A shape of an SVG.
#[derive(Debug)]
pub struct Shape {
    /// Tag of the element: `polyline`, `polygon`, `circle`, `text` …
    pub tag: String,
    /// Fill colour, or the stroke colour without a fill.
    pub ink: String,
    /// Corners, or the middle of a circle or the place of a text, pixels.
    pub points: Vec<[f64; 2]>,
    /// Width of the line, pixels.
    pub width: Option<f64>,
    /// Whether the line is dashed.
    pub dashed: bool,
    /// Words of a text.
    pub words: String,
    /// Font size of the words, pixels; 0 for other shapes.
    pub size: f64,
    /// Fraction of the width of the words that lies left of their place: 0, 0.5 or 1.
    pub left: f64,
}

/// All shapes except paths, in the order in which they are painted.
pub fn shapes(svg: &str) -> Result<Vec<Shape>, Failure> {
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

/// The closed polygons of each path element, pixels.
pub fn paths(svg: &str) -> Result<Vec<Vec<Vec<[f64; 2]>>>, Failure> {
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

/// Centres of circles of one colour, in the order in which they are painted, pixels.
pub fn circles(svg: &str, ink: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let circles = shapes(svg)?.into_iter().filter(|shape| shape.tag == "circle" && shape.ink == ink);
    Ok(circles.map(|circle| circle.points[0]).collect())
}

/// Width and height of the view box, pixels.
pub fn view_box(svg: &str) -> Result<[f64; 2], Failure> {
    let text = svg.split("viewBox=\"0 0 ").nth(1).and_then(|rest| rest.split('"').next());
    let (wide, high) = text.ok_or("a view box")?.split_once(' ').ok_or("two numbers")?;
    Ok([wide.parse()?, high.parse()?])
}

/// Left, top, right and bottom, pixels.
pub type Edges = [f64; 4];

/// The light backgrounds of names in a picture, one for each line of text.
pub fn plaques(svg: &str) -> Result<Vec<Edges>, Failure> {
    let grounds =
        svg.split('<').filter(|text| text.starts_with("polygon fill=\"#FFFFFF\" fill-opacity=\"0.75\""));
    let edges = |text: &str| -> Result<Edges, Failure> {
        let points =
            text.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).ok_or("points")?;
        let points = pairs(points)?;
        let most = |k: usize, pick: fn(f64, f64) -> f64| {
            points.iter().map(|p| p[k]).reduce(pick).unwrap_or(f64::NAN)
        };
        Ok([most(0, f64::min), most(1, f64::min), most(0, f64::max), most(1, f64::max)])
    };
    grounds.map(edges).collect()
}

/// The first two boxes that overlap by more than 0.02 pixels, the rounding of coordinates; `None` if no boxes overlap.
pub fn overlap(boxes: &[Edges]) -> Option<[Edges; 2]> {
    let meet = |a: &Edges, b: &Edges| (0..2).all(|k| a[k] + 0.02 < b[k + 2] && b[k] + 0.02 < a[k + 2]);
    let pairs = boxes.iter().enumerate().flat_map(|(k, a)| boxes[..k].iter().map(move |b| [*a, *b]));
    pairs.into_iter().find(|[a, b]| meet(a, b))
}

/// The first shape with a point outside of the view box; `None` without one.
pub fn outside(svg: &str) -> Result<Option<Shape>, Failure> {
    let [wide, high] = view_box(svg)?;
    let inside = |shape: &Shape| {
        shape.points.iter().all(|[x, y]| (0.0..=wide).contains(x) && (0.0..=high).contains(y))
    };
    Ok(shapes(svg)?.into_iter().find(|shape| !inside(shape)))
}
