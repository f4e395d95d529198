//! The picture of a planar grasp: object, fingers, friction cones, contact forces, load. A fingertip is a contact with all its points.

mod names;

use nalgebra::{Matrix3, Vector2, Vector3};

use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::ContactPoints;
use crate::numerics::{Each, IntoList, Reals, mapped, tried};
use crate::picture::actuators::Actuators;
use crate::picture::axes::{EqualScales, bounds};
use crate::picture::contact_look::{cone_ratio, cone_size, ink, word};
use crate::picture::error::PictureError;
use crate::picture::fingertip::Resultant;
use crate::picture::force_scale::metres_per_newton;
use crate::picture::layout::PLANAR;
use crate::picture::painting::{Painting, flat};
use crate::picture::palette::{GREY, Rgb, VERMILION};
use crate::picture::planar_link::PlanarLink;
use crate::picture::planar_load::{LoadOnPaper, PlanarLoad};
use crate::picture::planar_picture::PlanarPicture;
use crate::picture::sheet::{PaperPoint, sheet};
use crate::picture::way_out::MovedOutlines;
use crate::picture::window::Window;
use crate::picture::words::{caution, lines};

/// Layout of a picture, pixels.
struct PictureSize {
    size: PaperPoint,
    /// The rectangle for the grasp. Sentences below the title move it down.
    window: Window,
    /// Margins for names: to either side, and above and below the grasp.
    border: (f64, f64),
    /// Largest number of letters in a line of a sentence.
    letters: usize,
}

const OF_A_FILE: PictureSize = PictureSize {
    size: (860.0, 560.0),
    window: Window { left: 70.0, top: 46.0, wide: 776.0, high: 462.0 },
    border: (130.0, 62.0),
    letters: 96,
};
/// A layout small enough for its letters to be legible on a narrow screen.
const OF_A_PAGE: PictureSize = PictureSize {
    size: (520.0, 460.0),
    window: Window { left: 62.0, top: 10.0, wide: 448.0, high: 398.0 },
    border: (104.0, 58.0),
    letters: 58,
};

pub(super) struct Picture<'a> {
    of: &'a PlanarPicture<'a>,
    actuators: Actuators,
    tips: Vec<DrawnFingertip<'a>>,
    load: Option<PlanarLoad>,
    way_out: Option<MovedOutlines>,
    /// Largest extent of contact points, outlines and the rigid links of the hand's fingers along an axis, m; 1 m if all of these lie at one point.
    span: f64,
    /// Length of an arrow per unit of its force, m/N.
    scale: f64,
}

/// The pictures of the answers of one HTML page, as SVG, on the same axes and with the same scale of forces.
pub(super) fn stills_of_a_page(of: &[PlanarPicture]) -> Result<Vec<String>, PictureError> {
    of.iter().try_for_each(PlanarPicture::check)?;
    let mut pictures: Vec<_> = mapped(of, &Picture::new);
    let scales = pictures.iter().map(|picture| picture.scale).filter(|scale| *scale > 0.0);
    let scale = scales.least();
    for picture in &mut pictures {
        picture.scale = picture.scale.min(scale);
    }
    let points = mapped(&pictures, &Picture::points).concat();
    tried(&pictures, &|picture| picture.draw_on(&OF_A_PAGE, &points))
}

/// A fingertip with its contact frame, and its resultant force if there is an equilibrium.
struct DrawnFingertip<'a> {
    of: &'a ContactPoints,
    middle: Vector3<f64>,
    frame: Matrix3<f64>,
    cone_ratio: f64,
    link: Option<PlanarLink>,
    resultant: Option<Resultant>,
}

impl DrawnFingertip<'_> {
    fn normal(&self) -> Vector2<f64> {
        self.frame.column(0).xy()
    }

    fn tangent(&self) -> Vector2<f64> {
        self.frame.column(1).xy()
    }
}

impl<'a> Picture<'a> {
    pub(super) fn new(of: &'a PlanarPicture<'a>) -> Self {
        let PlanarPicture { grasp, outlines, .. } = of;
        let state = of.state.as_deref();
        let contacts = grasp.contacts();
        let points: Vec<_> = mapped(contacts, &|contact| contact.point.xy());
        let held = [&points[..], &outlines.concat()].concat();
        let (low, high) = bounds(held.iter().copied());
        // A single contact has no extent; 1 m is used as its size.
        let size =
            |(low, high): (Vector2<f64>, Vector2<f64>)| if low == high { 1.0 } else { (high - low).amax() };
        let load = state.map(|state| state.load).or(of.load);
        let load = load.map(|load| PlanarLoad::new(&load, low / 2.0 + high / 2.0, size((low, high))));
        let span = size(bounds([held, ends_of_bones(grasp)].concat()));
        let frames: Vec<_> = grasp.frames().copied().list();
        let tip = |tip: &'a ContactPoints| DrawnFingertip {
            middle: tip.middle(contacts),
            frame: frames[tip.range.start],
            cone_ratio: cone_ratio(&contacts[tip.range.start]),
            link: PlanarLink::of(tip, contacts),
            resultant: state.map(|state| tip.resultant(contacts, state)),
            of: tip,
        };
        let tips: Vec<_> = mapped(grasp.engine.wholes(), &tip);
        let loaded = load.as_ref().map_or(0.0, |load| load.force.norm());
        let doing = || tips.iter().filter_map(|tip| Some((tip, tip.resultant.as_ref()?)));
        let most = doing().map(|(_, resultant)| resultant.force.norm()).fold(loaded, f64::max);
        let push = |(tip, resultant): (&DrawnFingertip, &Resultant)| {
            (tip.middle, tip.frame.column(0).into_owned(), resultant.normal_force)
        };
        let pushes: Vec<_> = doing().map(push).list();
        let scale = metres_per_newton(&pushes, size((low, high)), most);
        let way_out = of
            .leaving
            .as_ref()
            .and_then(|motion| MovedOutlines::new(motion, outlines, points.into_iter(), size((low, high))));
        Self { of, actuators: Actuators::of(grasp), tips, load, way_out, span, scale }
    }

    fn state(&self) -> Option<&Equilibrium<3>> {
        self.of.state.as_deref()
    }

    pub(super) fn draw(&self) -> Result<String, PictureError> {
        self.draw_on(&OF_A_FILE, &self.points())
    }

    /// Draws the picture at a scale at which all `points` fit.
    fn draw_on(&self, paper: &PictureSize, points: &[Vector2<f64>]) -> Result<String, PictureError> {
        let PictureSize { size, window, border, .. } = *paper;
        let title = lines(self.of.title, 70);
        let caution = caution(self.state(), self.of.says.iter().copied());
        let sentences = self.of.says.iter().copied().chain(caution.as_deref());
        let mut says = Vec::new();
        for words in sentences {
            says.extend(lines(words, paper.letters));
        }
        // Line heights of the title and of the sentences below the title, pixels.
        let line_heights = (24.0, 20.0);
        let more = line_heights.0 * title.len().saturating_sub(1) as f64 + line_heights.1 * says.len() as f64;
        let window = Window { top: window.top + more, ..window };
        let axes = EqualScales::new(window, border, points.to_vec());
        if !axes.are_finite() {
            return Err(PictureError("a length or force is too large or too small to be drawn".into()));
        }
        let mut painting = Painting::default();
        self.paint_object(&axes, &mut painting);
        for tip in &self.tips {
            self.paint_tip(&axes, &mut painting, tip);
        }
        let load = self.load.as_ref().map(|load| LoadOnPaper::new(load, &axes, self.scale));
        if let Some(load) = &load {
            load.paint(&axes, &mut painting);
        }
        let place = |point| axes.place(point);
        let leaves = self.way_out.as_ref().and_then(|way| way.paint(&mut painting, &place));
        Ok(sheet((size.0, size.1 + more), &mut |paper| {
            for (k, line) in title.iter().enumerate() {
                paper.title_line(line_heights.0 * k as f64, line);
            }
            for (k, line) in says.iter().rev().enumerate() {
                paper.text(
                    (18.0, window.top - 14.0 - line_heights.1 * k as f64),
                    line,
                    PLANAR.letters,
                    0.0,
                    GREY,
                );
            }
            axes.draw(paper);
            painting.draw(paper);
            self.write_names(&axes, (paper, window, &painting), (load.as_ref(), leaves));
        }))
    }

    /// All points that must lie inside the picture, m.
    fn points(&self) -> Vec<Vector2<f64>> {
        let mut points = [self.of.outlines.concat(), ends_of_bones(&self.of.grasp)].concat();
        for tip in &self.tips {
            if let Some(link) = &tip.link {
                points.extend(link.ends);
                continue;
            }
            points.extend(self.finger(tip));
            if let Some(resultant) = &tip.resultant {
                let (at, force) = (resultant.at.xy(), resultant.force.xy() * self.scale);
                points.extend([at, at + force]);
                if self.of.grasp.contacts()[tip.of.range.start].against.is_some() {
                    points.push(at - force);
                }
                if let Some(cone) = self.cone(tip, resultant) {
                    points.extend(cone);
                }
            }
        }
        if let Some(load) = &self.load {
            points.extend([load.at, load.at + load.force * self.scale]);
        }
        if let Some(way_out) = &self.way_out {
            points.extend(way_out.points());
        }
        points
    }

    fn paint_object(&self, axes: &EqualScales, painting: &mut Painting) {
        let place = |point: &Vector2<f64>| axes.place(*point);
        for bone in self.of.grasp.links() {
            painting.line(bone.each(|end| flat(axes.place(end.xy()))), GREY, 3.0);
        }
        for (_, at) in &self.actuators.joints {
            if let Some(at) = at {
                painting.dot(flat(place(&at.xy())), 5.0, GREY, false);
            }
        }
        if let Some(state) = self.state() {
            for (_, at) in self.actuators.that_yield(state) {
                if let Some(at) = at {
                    painting.dot(flat(place(&at.xy())), 8.0, VERMILION, false);
                }
            }
        }
        for outline in self.of.outlines.iter().filter(|outline| outline.len() > 2) {
            painting.area(outline.iter().map(place).list(), GREY.mix(0.12), -3.0);
            for (k, corner) in outline.iter().enumerate() {
                let next = &outline[(k + 1) % outline.len()];
                painting.line([corner, next].each(|end| flat(place(end))), GREY, 1.0);
            }
        }
    }

    fn paint_tip(&self, axes: &EqualScales, painting: &mut Painting, tip: &DrawnFingertip) {
        let place = |point| axes.place(point);
        if let Some(link) = &tip.link {
            link.paint(axes, painting);
        } else if self.of.grasp.contacts()[tip.of.range.start].against.is_none() {
            painting.area(
                mapped(&self.finger(tip), &|corner| place(*corner)),
                Rgb(176, 176, 176).into(),
                -2.0,
            );
        }
        let Some(resultant) = &tip.resultant else {
            painting.dot(flat(place(tip.middle.xy())), 4.0, GREY, true);
            return;
        };
        let (at, force, what) = (resultant.at.xy(), resultant.force.xy() * self.scale, resultant.word);
        if let Some(cone) = self.cone(tip, resultant) {
            painting.area(mapped(&cone, &|corner| place(*corner)), ink(what).mix(0.16), -1.0);
            for edge in [cone[1], cone[2]] {
                painting.line([cone[0], edge].each(|end| flat(place(end))), ink(what), 1.0);
            }
        }
        painting.arrow([at, at + force].each(|end| flat(place(end))), ink(what), 3.0, 1);
        if self.of.grasp.contacts()[tip.of.range.start].against.is_some() {
            // The opposite force is drawn, too: the reaction on the body on the other side of the contact.
            painting.arrow([at, at - force].each(|end| flat(place(end))), ink(what), 1.5, 1);
        }
        for i in tip.of.range.clone().filter(|_| tip.of.is_soft()) {
            let point = self.of.grasp.contacts()[i].point.xy();
            let what = self.state().map_or("", |state| word(&state.contacts[i]));
            painting.dot(flat(place(point)), 2.5, ink(what), false);
        }
    }

    /// The corners of the finger, a wedge behind the contact.
    fn finger(&self, tip: &DrawnFingertip) -> [Vector2<f64>; 3] {
        let (middle, n, t) = (tip.middle.xy(), tip.normal(), tip.tangent());
        let corner = |side: f64| middle + (t * (0.35 * side) - n) * (PLANAR.finger * self.span);
        [middle, corner(1.0), corner(-1.0)]
    }

    /// The corners of the friction cone; `None` without friction or normal force.
    fn cone(&self, tip: &DrawnFingertip, resultant: &Resultant) -> Option<[Vector2<f64>; 3]> {
        let (at, n, t) = (resultant.at.xy(), tip.normal(), tip.tangent());
        let [high, wide] = cone_size(tip.cone_ratio, resultant.normal_force * self.scale, self.span / 2.0)?;
        let corner = |side: f64| at + n * high + t * (side * wide);
        Some([at, corner(1.0), corner(-1.0)])
    }
}

/// The ends of all rigid links of the hand's fingers.
fn ends_of_bones(grasp: &Grasp<3>) -> Vec<Vector2<f64>> {
    mapped(&grasp.links().concat(), &|end| end.xy())
}
