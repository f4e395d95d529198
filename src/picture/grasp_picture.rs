//! A planar grasp: object, fingers, friction cones, contact forces, load.

use nalgebra::Vector2;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::actuators::Actuators;
use super::canvas::{Canvas, Plotted};
use super::contact_look::{slope, word};
use super::error::PictureError;
use super::palette::{BLUE, FONT, GREEN, GREY, VERMILION};
use crate::planar::{Equilibrium, Grasp};

/// The outline of the object: corners (x, y) in order, m; the last is joined to the first. It is
/// only drawn.
pub type Outline<'a> = &'a [[f64; 2]];

const WIDTH: u32 = 860;
const HEIGHT: u32 = 560;

/// Draws a grasp with its contact forces inside their friction cones. Arrows are forces on the
/// object, the largest of them or of the load a third as long as contacts and outline extend; cones
/// are a little longer than the normal forces in them. The load's force is drawn at the origin, its
/// moment is not drawn. Links of a [hand](crate::grasp::Hand) are drawn where they were before anything moved; joints and tendons that yield at
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
/// outline is not finite, or if the back end fails.
pub fn draw_grasp<const D: usize>(
    grasp: &crate::grasp::Grasp<D, 2>,
    state: &crate::equilibrium::Equilibrium<D, 2>,
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
    let mut svg = String::new();
    let bones = grasp.links().copied().collect();
    Picture::new(&grasp.without_hand(), &state.without_hand(), outline, bones, Actuators::of(grasp))
        .draw(&mut svg, title)
        .map_err(PictureError::from_backend)?;
    Ok(svg)
}

struct Picture<'a> {
    grasp: &'a Grasp,
    state: &'a Equilibrium,
    outline: Vec<Vector2<f64>>,
    /// Links of a hand, from joint to joint.
    bones: Vec<[Vector2<f64>; 2]>,
    actuators: Actuators<2>,
    /// Size of the scene, m.
    span: f64,
    /// m per N.
    scale: f64,
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
        let (low, high) =
            bounds(points(grasp).chain(outline.iter().copied()).chain(bones.iter().flatten().copied()));
        let span = (high - low).amax().max(f64::MIN_POSITIVE);
        let load = force_of_load(state).norm();
        let most = state.contacts.iter().map(|c| c.force.norm()).fold(load, f64::max);
        let scale = if most > 0.0 { span / 3.0 / most } else { 0.0 };
        Self { grasp, state, outline, bones, actuators, span, scale }
    }

    fn draw(&self, svg: &mut String, title: &str) -> Plotted {
        let root = SVGBackend::with_string(svg, (WIDTH, HEIGHT)).into_drawing_area();
        root.fill(&WHITE)?;
        let load_tip = force_of_load(self.state) * self.scale;
        let drawn = self.outline.iter().chain(self.bones.iter().flatten()).copied();
        let everything = points(self.grasp).chain(drawn).chain([load_tip, Vector2::zeros()]);
        let (low, high) = bounds(everything);
        let margin = Vector2::new(0.35, 0.25) * self.span;
        let (low, high) = equal_aspect(low - margin, high + margin);
        let mut chart = ChartBuilder::on(&root)
            .caption(title, (FONT, 20))
            .margin(12)
            .x_label_area_size(40)
            .y_label_area_size(56)
            .build_cartesian_2d(low.x..high.x, low.y..high.y)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("x (m)")
            .y_desc("y (m)")
            .label_style((FONT, 13))
            .draw()?;
        for bone in &self.bones {
            chart.draw_series([PathElement::new(bone.map(|p| (p.x, p.y)).to_vec(), GREY.stroke_width(3))])?;
        }
        for at in self.actuators.joints.iter().filter_map(|(_, at)| *at) {
            chart.draw_series([Circle::new((at.x, at.y), 5, GREY.filled())])?;
        }
        if self.outline.len() > 2 {
            let corners: Vec<_> = self.outline.iter().map(|p| (p.x, p.y)).collect();
            chart.draw_series([Polygon::new(corners.clone(), GREY.mix(0.12))])?;
            let closed = corners.iter().copied().chain(corners.first().copied());
            chart.draw_series([PathElement::new(closed.collect::<Vec<_>>(), GREY.stroke_width(1))])?;
        }
        for contact in 0..self.grasp.len() {
            self.draw_contact(&mut chart, contact)?;
        }
        if load_tip.norm() > 0.0 {
            self.arrow(&mut chart, Vector2::zeros(), load_tip, VERMILION)?;
            let size = force_of_load(self.state).norm();
            self.label(
                &mut chart,
                load_tip + Vector2::new(0.02, 0.0) * self.span,
                HPos::Left,
                &format!("load {size:.4} N"),
            )?;
        }
        let corner = low + Vector2::new(0.02, 0.03) * self.span;
        self.mark_what_yields(&mut chart, corner)?;
        root.present()?;
        Ok(())
    }

    /// Joints at their limit where they are; what has no place is listed in a corner.
    fn mark_what_yields(&self, chart: &mut Canvas, corner: Vector2<f64>) -> Plotted {
        let mut elsewhere = Vec::new();
        for (name, at) in self.actuators.that_yield(self.state) {
            let Some(at) = at else {
                elsewhere.push(name);
                continue;
            };
            chart.draw_series([Circle::new((at.x, at.y), 8, VERMILION.filled())])?;
            let beside = at + Vector2::new(0.03, 0.0) * self.span;
            self.label(chart, beside, HPos::Left, &format!("{name} yields"))?;
        }
        if !elsewhere.is_empty() {
            self.label(chart, corner, HPos::Left, &format!("At their limit: {}", elsewhere.join(", ")))?;
        }
        Ok(())
    }

    fn draw_contact(&self, chart: &mut Canvas, index: usize) -> Plotted {
        let (contact, answer) = (&self.grasp.contacts()[index], &self.state.contacts[index]);
        let Some(frame) = self.grasp.frames().nth(index) else { return Ok(()) };
        let (p, n, t) = (contact.point, frame.column(0).into_owned(), frame.column(1).into_owned());
        // The finger: a wedge behind the contact.
        let finger = [p, p + (t * 0.35 - n) * (0.09 * self.span), p - (t * 0.35 + n) * (0.09 * self.span)];
        chart.draw_series([Polygon::new(finger.map(|v| (v.x, v.y)).to_vec(), GREY.mix(0.55))])?;
        let length = 1.15 * answer.normal_force() * self.scale;
        let mu = slope(contact);
        if mu > 0.0 && length > 0.0 {
            let cone = [p, p + (n + t * mu) * length, p + (n - t * mu) * length];
            chart.draw_series([Polygon::new(cone.map(|v| (v.x, v.y)).to_vec(), GREEN.mix(0.2))])?;
            for edge in [cone[1], cone[2]] {
                let line = [(p.x, p.y), (edge.x, edge.y)];
                chart.draw_series([PathElement::new(line, GREEN.mix(0.8).stroke_width(1))])?;
            }
        }
        self.arrow(chart, p, p + answer.force_world * self.scale, BLUE)?;
        let name = contact.label_text(index);
        // Behind the finger, away from the object.
        let at = p - n * (0.12 * self.span);
        let side = if n.x > 0.3 {
            HPos::Right
        } else if n.x < -0.3 {
            HPos::Left
        } else {
            HPos::Center
        };
        let force = format!("|F| = {:.4} N", answer.force.norm());
        for (line, text) in [name.as_str(), word(answer), &force].into_iter().enumerate() {
            // Lines run downwards; a finger from above has them above itself.
            let up = 0.05 * self.span * (1.0 - line as f64 - n.y);
            self.label(chart, at + Vector2::new(0.0, up), side, text)?;
        }
        Ok(())
    }

    fn arrow(&self, chart: &mut Canvas, from: Vector2<f64>, to: Vector2<f64>, color: RGBColor) -> Plotted {
        let along = to - from;
        if along.norm() == 0.0 {
            return Ok(());
        }
        let head = along.normalize() * (0.03 * self.span).min(along.norm());
        let across = Vector2::new(-head.y, head.x) * 0.4;
        let neck = to - head;
        chart.draw_series([PathElement::new([(from.x, from.y), (neck.x, neck.y)], color.stroke_width(3))])?;
        let tip = [to, neck + across, neck - across].map(|v| (v.x, v.y)).to_vec();
        chart.draw_series([Polygon::new(tip, color)])?;
        Ok(())
    }

    #[expect(clippy::unused_self, reason = "reads like the other strokes")]
    fn label(&self, chart: &mut Canvas, at: Vector2<f64>, side: HPos, text: &str) -> Plotted {
        let style = (FONT, 15).into_font().color(&BLACK).pos(Pos::new(side, VPos::Center));
        chart.draw_series([Text::new(text.to_owned(), (at.x, at.y), style)])?;
        Ok(())
    }
}

fn points(grasp: &Grasp) -> impl Iterator<Item = Vector2<f64>> + '_ {
    grasp.contacts().iter().map(|contact| contact.point)
}

fn force_of_load(state: &Equilibrium) -> Vector2<f64> {
    let w = state.load.as_vector();
    Vector2::new(w[0], w[1])
}

fn bounds(points: impl Iterator<Item = Vector2<f64>>) -> (Vector2<f64>, Vector2<f64>) {
    points.fold((Vector2::repeat(f64::INFINITY), Vector2::repeat(f64::NEG_INFINITY)), |(low, high), p| {
        (low.inf(&p), high.sup(&p))
    })
}

/// Widens one of the ranges so that a metre is as long upwards as sideways.
fn equal_aspect(low: Vector2<f64>, high: Vector2<f64>) -> (Vector2<f64>, Vector2<f64>) {
    let wanted = f64::from(WIDTH - 80) / f64::from(HEIGHT - 94);
    let size = high - low;
    let grown = if size.x > wanted * size.y {
        Vector2::new(size.x, size.x / wanted)
    } else {
        Vector2::new(size.y * wanted, size.y)
    };
    let middle = (low + high) / 2.0;
    (middle - grown / 2.0, middle + grown / 2.0)
}
