//! The data of a page as JSON.

use nalgebra::Vector3;

use super::drawing::{Drawing, twist_of};
use super::eye::View;
use super::frame::Frame;
use super::spatial_page::MovingLine;
use super::text::{json_number, json_row, json_string};
use crate::numerics::tried;
use crate::picture::contact_look::{slope, word};
use crate::picture::error::PictureError;
use crate::picture::layout::{MARKS, SPATIAL};
use crate::picture::words::short;
use crate::spatial::Equilibrium;

impl Drawing<'_> {
    pub(super) fn json(&self) -> Result<String, PictureError> {
        let page = self.page;
        let lines =
            |lines: &[Vec<[f64; 3]>]| list(lines, &|corners| list(corners, &|corner| json_row(corner)));
        let outlines = list(&page.outlines, &|line| list(&line.corners, &|corner| json_row(corner)))?;
        let (fixtures, bodies) = (lines(&page.fixtures)?, lines(&self.bodies)?);
        let (contacts, frames): (_, Vec<_>) = (page.grasp.contacts(), page.grasp.frames().collect());
        let tips = list(&self.tips, &|tip| {
            let frame = frames[tip.contacts.start];
            let points =
                list(&contacts[tip.contacts.clone()], &|contact| json_row(contact.point().as_slice()))?;
            let row = |end: &Vector3<f64>| json_row(end.as_slice());
            let line = tip.ends_of_link(contacts).map(|ends| list(&ends, &row)).transpose()?;
            let line = line.map_or(String::new(), |line| format!(",\"line\":{line}"));
            Ok(format!(
                "{{\"name\":{},\"point\":{},\"points\":{points},\"normal\":{},\"tangents\":[{},{}]{line}}}",
                json_string(&tip.name),
                json_row(tip.middle(contacts).as_slice())?,
                json_row(frame.column(0).as_slice())?,
                json_row(frame.column(1).as_slice())?,
                json_row(frame.column(2).as_slice())?
            ))
        })?;
        let frames = list(&page.frames, &|frame| self.frame(frame))?;
        let lengths = [
            ("span", self.span),
            ("finger", SPATIAL.finger * self.span),
            ("slip", SPATIAL.slip * self.span),
            ("axis", SPATIAL.axis * self.span),
            ("cone", MARKS.cone),
            ("force", self.force),
            ("moment", self.moment),
            ("shortest", MARKS.shortest_load),
            ("displacement", self.displacement),
        ];
        let lengths = tried(&lengths, &|(name, length)| {
            Ok::<_, PictureError>(format!("\"{name}\":{}", json_number(*length)?))
        })?;
        let View { yaw, pitch } = View::default();
        Ok(format!(
            "{{\"view\":{{\"yaw\":{},\"pitch\":{}}},\"centre\":{},{},\"many\":{},\n\"outlines\":{outlines},\n\"fixtures\":{fixtures},\n\"bodies\":{bodies},\n\"contacts\":{tips},\n\"frames\":{frames}}}",
            json_number(yaw)?,
            json_number(pitch)?,
            json_row(self.centre.as_slice())?,
            lengths.join(","),
            MARKS.most_named,
        ))
    }

    /// The parts of an answer as JSON; absent parts are omitted.
    fn frame(&self, frame: &Frame<3>) -> Result<String, PictureError> {
        let mut parts = frame.state().map(|state| self.state(frame, state)).transpose()?.unwrap_or_default();
        if let Some(load) = frame.load() {
            let load = self.load(load);
            let size = |size: f64, unit| json_string(&format!("{} {unit}", short(size)));
            parts.push(format!(
                "\"load\":{{\"at\":{},\"force\":{},\"moment\":{},\"newtons\":{},\"newton_metres\":{}}}",
                json_row(load.at.as_slice())?,
                json_row(load.force.as_slice())?,
                json_row(load.moment.as_slice())?,
                size(load.force.norm(), "N"),
                size(load.moment.norm(), "N m"),
            ));
        }
        if let Some(motion) = &frame.leaving {
            let way = self.way_out(motion);
            let row = |point: &Vector3<f64>| json_row(point.as_slice());
            let lines = list(&way.lines, &|corners| list(corners, &row))?;
            let arrows =
                list(&way.arrows, &|[from, to]| Ok(format!("[{},{}]", row(from)?, row(&(to - from))?)))?;
            parts.push(format!("\"leaves\":{{\"lines\":{lines},\"arrows\":{arrows}}}"));
        }
        Ok(if parts.is_empty() { "null".to_owned() } else { format!("{{{}}}", parts.join(",")) })
    }

    fn state(&self, frame: &Frame<3>, state: &Equilibrium) -> Result<Vec<String>, PictureError> {
        let given = self.page.grasp.contacts();
        let contacts = list(&self.tips, &|tip| {
            let resultant = tip.resultant(given, state);
            let slides = resultant.slides.map(|way| json_row(way.as_slice())).transpose()?;
            let state_of = |word: &str| json_string(&word.replace(' ', "-"));
            let states = list(&state.contacts[tip.contacts.clone()], &|answer| Ok(state_of(word(answer))))?;
            let first = tip.contacts.start;
            Ok(format!(
                "{{\"state\":{},\"states\":{states},\"at\":{},\"force\":{},\"normal_force\":{},\"mu\":{},\"displacement\":{},\"slides\":{}}}",
                state_of(resultant.word),
                json_row(resultant.at.as_slice())?,
                json_row(resultant.force.as_slice())?,
                json_number(resultant.normal_force)?,
                json_number(frame.slope(first, slope(&given[first])))?,
                json_row(resultant.displacement.as_slice())?,
                slides.unwrap_or_else(|| "null".to_owned()),
            ))
        })?;
        let free = list(&state.free_motions, &|motion| {
            let axis = self.axis(&motion.object);
            let (at, along) = (json_row(axis.at.as_slice())?, json_row(axis.along.as_slice())?);
            Ok(format!("{{\"at\":{at},\"along\":{along},\"turns\":{}}}", axis.turns))
        })?;
        let at = self.page.actuators.that_yield(state).filter_map(|(name, at)| Some((name, at?)));
        let yields = list(&at.collect::<Vec<_>>(), &|(name, at)| {
            Ok(format!("{{\"name\":{},\"at\":{}}}", json_string(name), json_row(at.as_slice())?))
        })?;
        let of_line = |line: &MovingLine| json_row(twist_of(state, line.body).components());
        // For several bodies, one twist for each outline.
        let twists = if state.bodies.is_empty() {
            String::new()
        } else {
            format!(",\"twists\":{}", list(&self.page.outlines, &of_line)?)
        };
        Ok(vec![
            format!("\"twist\":{}{twists}", json_row(state.twist.components())?),
            format!("\n\"contacts\":{contacts},\"free\":{free},\"yields\":{yields}"),
        ])
    }
}

fn list<T>(items: &[T], write: &dyn Fn(&T) -> Result<String, PictureError>) -> Result<String, PictureError> {
    Ok(format!("[{}]", tried(items, write)?.join(",")))
}
