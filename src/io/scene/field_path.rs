//! The field of a JSON text at which the JSON parser stopped (feature `json`).

/// Beginnings of serde_json messages that concern a whole list or object, and not one value in it.
const OF_A_LIST_OR_OBJECT: [&str; 7] = [
    "EOF while parsing a list",
    "EOF while parsing an object",
    "expected `,`",
    "expected `:`",
    "trailing",
    "key must be a string",
    "duplicate field",
];

/// The path of the field that caused an error of the JSON parser, such as `planar.contacts[1].friction`; `None` for the whole text. `read` is the
/// number of bytes that were read, and `message` is the message of the error.
pub(super) fn faulty_field(
    text: &[u8],
    read: usize,
    error: &serde_json::Error,
    message: &str,
) -> Option<String> {
    let (before, last) = text.split_at(read.saturating_sub(1));
    // At a syntax error the last byte that was read is the first byte that is not JSON. If instead the text ends too early or a value is wrong, all
    // bytes that were read are JSON. A unit variant, i.e. a name without the fields that it needs, is reported at the byte after the name.
    let alone = message.starts_with("invalid type: unit variant");
    let json = if error.is_syntax() || alone { before } else { &text[..read] };
    // If a list is not allowed, the position that serde_json gives is either that of the opening bracket of the list or one byte before it.
    let behind = last.starts_with(b"[") && !last[1..].starts_with(b"[");
    let around = (behind && message.starts_with("invalid type: sequence"))
        || OF_A_LIST_OR_OBJECT.iter().any(|of| message.starts_with(of));
    let mut path = field_path(json, around);
    // An unknown name counts as a fault of the object that contains it.
    let unknown = message.strip_prefix("unknown variant `").and_then(|rest| rest.split('`').next());
    if let Some(object) = unknown.and_then(|name| path.strip_suffix(name)?.strip_suffix('.')) {
        path.truncate(object.len());
    }
    Some(path).filter(|path| !path.is_empty())
}

/// A JSON list or object whose closing bracket is not yet read.
struct Open {
    /// The length in bytes of the path of this list or object, such as `planar.contacts[1]`.
    path: usize,
    /// The index, from 0, of the present element of a list; `None` for an object.
    element: Option<usize>,
}

/// The path of the value at the end of `read`; empty for the whole text. If `around` is true, the path of the list or object that contains this
/// value. All of `read` must be the beginning of a JSON text.
fn field_path(read: &[u8], around: bool) -> String {
    let mut path = String::new();
    let mut open: Vec<Open> = Vec::new();
    let mut name_next = false;
    let mut i = 0;
    while let Some(byte) = read.get(i) {
        let start = i;
        i += 1;
        match byte {
            b'[' | b'{' => {
                let is_list = *byte == b'[';
                open.push(Open { path: path.len(), element: is_list.then_some(0) });
                if is_list {
                    path.push_str("[0]");
                }
                name_next = !is_list;
            }
            b']' | b'}' => path.truncate(open.pop().map_or(0, |closed| closed.path)),
            b',' => {
                let Some(present) = open.last_mut() else { break };
                path.truncate(present.path);
                match &mut present.element {
                    Some(element) => {
                        *element += 1;
                        path.extend(["[", &element.to_string(), "]"]);
                    }
                    None => name_next = true,
                }
            }
            b'"' => {
                while i < read.len() && read[i] != b'"' {
                    i += if read[i] == b'\\' { 2 } else { 1 };
                }
                i = read.len().min(i + 1);
                if name_next {
                    // A name that is cut off by the end of the text is not part of the path.
                    let Ok(name) = serde_json::from_slice::<String>(&read[start..i]) else { break };
                    if !path.is_empty() {
                        path.push('.');
                    }
                    path.push_str(&name);
                    name_next = false;
                }
            }
            _ => {}
        }
    }
    if around {
        path.truncate(open.last().map_or(0, |around| around.path));
    }
    path
}
