//! The reply to one line of the stream.

use serde::Serialize;

use super::line::{InputLine, LONGEST_LINE};
use super::options::StreamOptions;
use crate::error::Error;
use crate::numerics::mapped;
use crate::scene::{Answers, Brief, Fault, Id, Scene, Warning};
use crate::sweep::fault_in;

/// One line of output; [the stream](super) explains its fields.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Reply {
    line: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    id: Option<Id>,
    #[serde(skip_serializing_if = "Option::is_none")]
    hash: Option<String>,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    blank: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    answers: Option<Answers>,
    #[serde(skip_serializing_if = "Option::is_none")]
    brief: Option<Vec<Brief>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    warnings: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Fault>,
    #[serde(skip_serializing_if = "Option::is_none")]
    begins: Option<String>,
}

impl Reply {
    /// The reply to a line of input: the statement that the line is blank, the answers of its scene, or an error.
    pub(super) fn to(line: &InputLine, options: &StreamOptions) -> Self {
        let text = line.text.trim_ascii();
        let (answers, brief, warnings, error, begins) = (None, None, Vec::new(), None, None);
        let mut reply = Self {
            line: line.number,
            id: None,
            hash: None,
            blank: false,
            answers,
            brief,
            warnings,
            error,
            begins,
        };
        if line.too_long {
            reply.error = Some(Fault::of_scene(format!("longer than {LONGEST_LINE} bytes")));
            reply.begins = Some(beginning(text));
            return reply;
        }
        if text.is_empty() {
            reply.blank = true;
            return reply;
        }
        if let Some(fault) = fault_in(&mut || reply.read(text, options)) {
            (reply.answers, reply.brief) = (None, None);
            reply.error = Some(Fault::internal(&fault));
        }
        reply.hash = reply.id.is_none().then(|| format!("{:016x}", fnv1a(text)));
        reply
    }

    /// Reads a scene and puts its answers, or the fault of the text or of a question, into this reply.
    fn read(&mut self, text: &[u8], options: &StreamOptions) {
        match Scene::from_json(text) {
            Ok(mut scene) => {
                self.id = scene.id.take();
                assert!(!self.line.is_multiple_of(options.fails_every), "made to fail");
                self.error = self.answer(scene, options).err();
            }
            Err(fault) => {
                self.id = Fault::id_of(text);
                self.begins = self.id.is_none().then(|| beginning(text));
                self.error = Some(fault);
            }
        }
    }

    /// Whether the reply has answers and no error; `None` for a blank line.
    pub(super) fn is_answered(&self) -> Option<bool> {
        if self.blank { None } else { Some(self.error.is_none()) }
    }

    fn answer(&mut self, mut scene: Scene, options: &StreamOptions) -> Result<(), Fault> {
        let setup = &mut scene.setup;
        if setup.questions.is_empty() {
            return Err(Fault::of_scene("no questions: there is nothing to answer".to_owned()));
        }
        let refused = |error: Error| Fault::of_question(&error);
        let points = setup.all_points().map_err(refused)?;
        if points > options.most_points {
            let most = options.most_points;
            return Err(Fault::of_scene(format!(
                "{points} points of contact, must be at most {most} in this stream"
            )));
        }
        setup.settings.most_states = setup.settings.most_states.min(options.most_states);
        setup.settings.most_steps = setup.settings.most_steps.min(options.most_steps);
        self.warnings = mapped(&setup.all_warnings().map_err(refused)?, &Warning::to_string);
        if options.brief {
            self.brief = Some(setup.answered_briefly().map_err(refused)?);
        } else {
            self.answers = Some(scene.answers().map_err(refused)?);
        }
        Ok(())
    }
}

fn beginning(text: &[u8]) -> String {
    // Without an id, a reply contains the first 60 characters of the line to identify it.
    let beginning = 60;
    String::from_utf8_lossy(&text[..text.len().min(4 * beginning)]).chars().take(beginning).collect()
}

/// The hash FNV-1a (G. Fowler, L. C. Noll and K.-P. Vo, *The FNV Non-Cryptographic Hash Algorithm*), which users can implement in a few lines of any
/// language.
fn fnv1a(text: &[u8]) -> u64 {
    text.iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
