//! A planar grasp: object, fingers, friction cones, contact forces, load.

use nalgebra::{Matrix2, Vector2};
use plotters::style::{Color, RGBColor, colors::BLACK};

use super::actuators::Actuators;
use super::axes::{EqualScales, bounds};
use super::contact_look::{ink, slope, word};
use super::error::PictureError;
use super::fingertip::{ContactGroup, Resultant, fingertips};
use super::force_scale::metres_per_newton;
use super::labels::Labels;
use super::painting::{Painting, flat};
use super::palette::{GREY, VERMILION};
use super::planar_load::PlanarLoad;
use super::sheet::{Place, Sheet, sheet};
use super::window::Window;
use super::words::short;
use crate::planar::{Equilibrium, Grasp};

/// The outline of the object: corners (x, y) in order, m; the last is joined to the first. It is
/// only drawn.
pub type Outline<'a> = &'a [[f64; 2]];

const SIZE: Place = (860.0, 560.0);
const WINDOW: Window = Window { left: 70.0, top: 46.0, wide: 776.0, high: 462.0 };
/// Room for names beside the grasp, pixels to either side, and above and below.
const BORDER: (f64, f64) = (130.0, 62.0);
/// Height of letters, and radius of the arc of a moment.
const LETTERS: f64 = 15.0;
const ARC: f64 = 30.0;
/// A finger behind its contact, and where its name goes, in parts of the span.
const FINGER: f64 = 0.08;
/// The finger.
const PALE: RGBColor = RGBColor(176, 176, 176);
/// How much longer a cone is than the arrow of the normal force in it.
const CONE: f64 = 1.15;

/// Draws a grasp with its contact forces inside their friction cones. Arrows are forces on the
/// object, at one scale, so short that they do not go through it; cones are a little longer than
/// the normal forces in them. The load is drawn on its line of action, which is dashed. Where that
/// line passes the grasp by, or the load is a moment alone, its force is drawn in the middle of the
/// grasp and its moment about that point as an arc. All points of a
/// [soft fingertip](crate::planar::SoftFingertip) have one force and one cone, at their centre of
/// pressure; dots are the points, in the colours of what they do. Links of a [hand](crate::grasp::Hand) are drawn where they were before anything moved; joints and tendons that yield at
/// their limit are marked.
///
/// ```
/// use grasp_lcp::picture::draw_grasp;
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
///
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
/// let outcome = grasp.solve(&Wrench::force([0.0, -6.0]))?;
/// let state = outcome.equilibrium().ok_or("it holds")?;
/// let svg = draw_grasp(&grasp, state, Some(&[[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]]), "A pinch")?;
/// assert!(svg.starts_with("<svg"));
/// // The state of another grasp, or a corner that is nowhere, is no picture.
/// assert!(draw_grasp(&Grasp::new([finger(-1.0)])?, state, None, "A finger").is_err());
/// assert!(draw_grasp(&grasp, state, Some(&[[f64::INFINITY, 0.0]]), "A pinch").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PictureError`] if the equilibrium has not as many contacts as the grasp, if a corner of the
/// outline is not finite, or if a length or force is too large or too small to be drawn.
pub fn draw_grasp(
    grasp: &Grasp,
    state: &Equilibrium,
    outline: Option<Outline>,
    title: &str,
) -> Result<String, PictureError> {
    if state.contacts.len() != grasp.len() {
        let (given, expected) = (state.contacts.len(), grasp.len());
        return Err(PictureError(format!("the equilibrium has {given} contacts, the grasp has {expected}")));
    }
    if !outline.unwrap_or_default().iter().flatten().all(|x| x.is_finite()) {
        return Err(PictureError("a corner of the outline is not finite".into()));
    }
    Picture::new(grasp, state, outline, grasp.links().to_vec(), Actuators::of(grasp)).draw(title)
}

struct Picture<'a> {
    grasp: &'a Grasp,
    state: &'a Equilibrium,
    outline: Vec<Vector2<f64>>,
    /// Links of a hand, from joint to joint.
    bones: Vec<[Vector2<f64>; 2]>,
    actuators: Actuators<2>,
    tips: Vec<Tip>,
    load: PlanarLoad,
    /// Size of the scene, m.
    span: f64,
    /// m per N.
    scale: f64,
}

/// A fingertip, its contact frame, and what it does.
struct Tip {
    of: ContactGroup,
    middle: Vector2<f64>,
    frame: Matrix2<f64>,
    slope: f64,
    does: Resultant<2>,
}

impl<'a> Picture<'a> {
    fn new(
        grasp: &'a Grasp,
        state: &'a Equilibrium,
        outline: Option<Outline>,
        bones: Vec<[Vector2<f64>; 2]>,
        actuators: Actuators<2>,
    ) -> Self {
        let outline: Vec<_> = outline.unwrap_or_default().iter().map(|p| Vector2::from(*p)).collect();
        let contacts = grasp.contacts();
        let held = || contacts.iter().map(|contact| contact.point).chain(outline.iter().copied());
        let (low, high) = bounds(held());
        // A single contact has no size of its own.
        let size =
            |(low, high): (Vector2<f64>, Vector2<f64>)| if low == high { 1.0 } else { (high - low).amax() };
        let load = PlanarLoad::new(&state.load, low / 2.0 + high / 2.0, size((low, high)));
        let span = size(bounds(held().chain(bones.iter().flatten().copied())));
        let frames: Vec<_> = grasp.frames().copied().collect();
        let tip = |of: ContactGroup| Tip {
            middle: of.middle(contacts),
            frame: frames[of.contacts.start],
            slope: slope(&contacts[of.contacts.start]),
            does: of.resultant(contacts, &state.contacts),
            of,
        };
        let tips: Vec<_> = fingertips(contacts).into_iter().map(tip).collect();
        let most = tips.iter().map(|tip| tip.does.force.norm()).fold(load.force.norm(), f64::max);
        let push = |tip: &Tip| (tip.middle, tip.frame.column(0).into_owned(), tip.does.normal_force);
        let pushes: Vec<_> = tips.iter().map(push).collect();
        let scale = metres_per_newton(&pushes, size((low, high)), most);
        Self { grasp, state, outline, bones, actuators, tips, load, span, scale }
    }

    fn draw(&self, title: &str) -> Result<String, PictureError> {
        let of_tips = self.tips.iter().flat_map(|tip| {
            let force = [tip.does.at, tip.does.at + tip.does.force * self.scale];
            force.into_iter().chain(self.finger(tip)).chain(self.cone(tip).into_iter().flatten())
        });
        let of_load = [self.load.at, self.load.at + self.load.force * self.scale];
        let drawn = self.outline.iter().chain(self.bones.iter().flatten()).copied();
        let axes = EqualScales::new(WINDOW, BORDER, drawn.chain(of_tips).chain(of_load));
        if !axes.are_finite() {
            return Err(PictureError("a length or force is too large or too small to be drawn".into()));
        }
        let mut painting = Painting::default();
        self.paint_object(&axes, &mut painting);
        for tip in &self.tips {
            self.paint_tip(&axes, &mut painting, tip);
        }
        self.paint_load(&axes, &mut painting);
        Ok(sheet(SIZE, |paper| {
            paper.title(title);
            axes.draw(paper);
            painting.draw(paper);
            let mut labels = Labels::new(WINDOW.within(4.0), painting.ink());
            for tip in &self.tips {
                // Behind the finger, away from the object.
                let at = axes.place(tip.middle - tip.frame.column(0) * (FINGER * self.span));
                let force = format!("|F| = {} N", short(tip.does.force.norm()));
                labels.write(paper, at, &[&tip.of.name, tip.does.word, &force], LETTERS);
            }
            self.write_load(&axes, paper, &mut labels);
            let mut elsewhere = Vec::new();
            for (name, at) in self.actuators.that_yield(self.state) {
                match at {
                    Some(at) => labels.write(paper, axes.place(at), &[&format!("{name} yields")], LETTERS),
                    None => elsewhere.push(name),
                }
            }
            if !elsewhere.is_empty() {
                let words = format!("At their limit: {}", elsewhere.join(", "));
                paper.plaque((WINDOW.left + 8.0, WINDOW.top + 14.0), &words, LETTERS, 0.0);
            }
        }))
    }

    fn paint_object(&self, axes: &EqualScales, painting: &mut Painting) {
        let place = |point: &Vector2<f64>| axes.place(*point);
        for bone in &self.bones {
            painting.line(bone.map(|end| flat(axes.place(end))), GREY, 3.0);
        }
        for (_, at) in &self.actuators.joints {
            if let Some(at) = at {
                painting.dot(flat(place(at)), 5.0, GREY, false);
            }
        }
        for at in self.actuators.that_yield(self.state).filter_map(|(_, at)| at) {
            painting.dot(flat(place(&at)), 8.0, VERMILION, false);
        }
        if self.outline.len() > 2 {
            painting.area(self.outline.iter().map(place), GREY.mix(0.12), -3.0);
            for (k, corner) in self.outline.iter().enumerate() {
                let next = &self.outline[(k + 1) % self.outline.len()];
                painting.line([corner, next].map(|end| flat(place(end))), GREY, 1.0);
            }
        }
    }

    fn paint_tip(&self, axes: &EqualScales, painting: &mut Painting, tip: &Tip) {
        let Resultant { at, force, word: does, .. } = tip.does;
        let place = |point| axes.place(point);
        painting.area(self.finger(tip).map(place), PALE.to_rgba(), -2.0);
        if let Some(cone) = self.cone(tip) {
            painting.area(cone.map(place), ink(does).mix(0.16), -1.0);
            for edge in [cone[1], cone[2]] {
                painting.line([cone[0], edge].map(|end| flat(place(end))), ink(does), 1.0);
            }
        }
        painting.arrow([at, at + force * self.scale].map(|end| flat(place(end))), ink(does), 3.0, 1);
        for i in tip.of.contacts.clone().filter(|_| tip.of.is_soft()) {
            let (point, answer) = (self.grasp.contacts()[i].point, &self.state.contacts[i]);
            painting.dot(flat(place(point)), 2.5, ink(word(answer)), false);
        }
    }

    fn paint_load(&self, axes: &EqualScales, painting: &mut Painting) {
        let PlanarLoad { at, force, moment } = self.load;
        let tip = at + force * self.scale;
        let (from, to) = (axes.place(at), axes.place(tip));
        if force != Vector2::zeros() {
            painting.arrow([from, to].map(flat), BLACK, 3.0, 1);
        }
        if moment == 0.0 && force != Vector2::zeros() {
            painting.dashes(axes.across(at, force.normalize()), GREY, 1.0);
        }
        if moment != 0.0 {
            // Open where the force leaves.
            painting.arc(from, ARC, self.load.angle(), moment < 0.0, BLACK, 2.0);
            painting.dot(flat(from), 3.0, BLACK, false);
        }
    }

    fn write_load(&self, axes: &EqualScales, paper: &mut Sheet, labels: &mut Labels) {
        let PlanarLoad { at, force, moment } = self.load;
        if force != Vector2::zeros() {
            let tip = axes.place(at + force * self.scale);
            labels.write(paper, tip, &[&format!("load {} N", short(force.norm()))], LETTERS);
        }
        if moment != 0.0 {
            // Beside the arc, where it is closed.
            let ((x, y), (sin, cos)) = (axes.place(at), self.load.angle().sin_cos());
            let words = format!("moment {} N m", short(moment));
            labels.write(paper, (x - ARC * cos, y + ARC * sin), &[&words], LETTERS);
        }
    }

    /// The finger: a wedge behind the contact.
    fn finger(&self, tip: &Tip) -> [Vector2<f64>; 3] {
        let (n, t) = (tip.frame.column(0), tip.frame.column(1));
        let corner = |side: f64| tip.middle + (t * (0.35 * side) - n) * (FINGER * self.span);
        [tip.middle, corner(1.0), corner(-1.0)]
    }

    /// Corners of the friction cone, if there is one.
    fn cone(&self, tip: &Tip) -> Option<[Vector2<f64>; 3]> {
        let (n, t) = (tip.frame.column(0), tip.frame.column(1));
        let long = CONE * tip.does.normal_force * self.scale;
        // A cone that would fill the picture is drawn shorter.
        let wide = (tip.slope * long).min(self.span / 2.0);
        let corner = |side: f64| tip.does.at + n * (wide / tip.slope) + t * (side * wide);
        (tip.slope > 0.0 && long > 0.0).then(|| [tip.does.at, corner(1.0), corner(-1.0)])
    }
}
