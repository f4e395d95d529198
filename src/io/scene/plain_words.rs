//! Rewords messages of the JSON parser for the author of a scene.

use crate::numerics::IntoList;

/// Fields of a setup, which stand inside the object `planar` or `spatial` of a scene. If they stand beside this object, the error message gives a
/// hint.
const SETUP: [&str; 11] = [
    "contacts",
    "fingers",
    "tendons",
    "bodies",
    "links",
    "gravity",
    "loaded",
    "shared_by_mass",
    "outline",
    "questions",
    "settings",
];

/// Rewords a message of serde or serde_json for users. `here` is the byte of the text at the position of the error, if that position is known.
pub(super) fn in_plain_words(message: &str, here: Option<u8>) -> String {
    if let Some((given, wanted)) = message
        .strip_prefix("invalid type: ")
        .or_else(|| message.strip_prefix("invalid value: "))
        .and_then(|rest| rest.rsplit_once(", expected "))
    {
        return format!("{} given, must be {}", self::given_text(given), self::expected_text(wanted));
    }
    if let Some((length, wanted)) =
        message.strip_prefix("invalid length ").and_then(|rest| rest.split_once(", expected "))
    {
        let wanted = wanted.replace("an array of length", "a list of");
        return format!("a list of {length} given, must be {wanted}");
    }
    for kind in ["field", "variant"] {
        let unknown = format!("unknown {kind} `");
        if let Some((name, known)) = message.strip_prefix(&unknown).and_then(|rest| rest.split_once("`, ")) {
            let what = if kind == "field" { "unknown field `" } else { "unknown name `" };
            let allowed = known.strip_prefix("expected ").unwrap_or(known);
            let meant = match name {
                "mu" if allowed.contains("`friction`") => Some("friction"),
                _ => alike(name, allowed),
            };
            let lists = |name: &str| allowed.contains(&format!("`{name}`"));
            let meant = match name {
                _ if lists("planar") && SETUP.contains(&name) => {
                    " (it stands inside `planar` or `spatial`)".to_owned()
                }
                "force" | "moment" | "accelerated" | "turning" if lists("load") => {
                    format!(" (it stands inside `load`, `\"load\": {{\"{name}\": …}}`)")
                }
                "comment" | "unit" => " (it stands beside `planar` or `spatial`)".to_owned(),
                "mass" => {
                    " (it stands in a load, `\"load\": {\"mass\": 2}`, or in one of `bodies`)".to_owned()
                }
                _ => meant.map_or(String::new(), |meant| format!(" (`{meant}`?)")),
            };
            return format!("{what}{name}`{meant}, must be {allowed}");
        }
    }
    if let Some(field) = message.strip_prefix("duplicate field ") {
        return format!("field {field} stands there twice, must be once");
    }
    if let Some(what) = message.strip_prefix("EOF while parsing ") {
        return format!(
            "the text ends within {}: something is missing, perhaps a bracket",
            expected_text(what)
        );
    }
    match message {
        "expected value" | "expected ident" | "key must be a string" if here == Some(b',') => {
            "a comma in a row with another one, or with nothing in front of it"
        }
        "expected value" | "expected ident" | "key must be a string" if here == Some(b'\'') => {
            "names and texts stand in double quotes, not in single ones"
        }
        "expected value" | "expected ident" | "key must be a string" | "trailing characters"
            if here.is_some_and(|byte| b"/#".contains(&byte)) =>
        {
            "JSON has no comments: scenes, contacts and bodies have a field `comment` for a text"
        }
        // serde_json also gives the message "expected value" for a valid number or list if an enum is expected.
        "expected value" | "expected ident" if here.is_some_and(|byte| b"0123456789-[".contains(&byte)) => {
            "this is none of the values that are allowed here, must be a name in double quotes, or an object"
        }
        "expected value" | "expected ident" => {
            "no value begins like this: texts and names stand in double quotes, numbers begin with a digit or a minus, and there is no NaN"
        }
        "key must be a string" => {
            "the name of a field must stand here, in double quotes (and a decimal comma must be a point)"
        }
        "trailing characters" => "there is more text behind the end of the scene, must be nothing",
        "trailing comma" => "the comma has nothing behind it, or there are two fields where one is allowed",
        "number out of range" => "a number too large to be read, must be at most 1e50 in size",
        "invalid number" => "no number: write it as 0.5, -3 or 1e6",
        other => other,
    }
    .to_owned()
}

/// Plain words for the value that serde has found.
fn given_text(what: &str) -> &str {
    match what {
        "map" => "an object",
        "sequence" => "a list",
        "unit variant" => "a name alone",
        "newtype variant" | "struct variant" | "tuple variant" => "a name with something",
        // serde writes a number as ``integer `5` `` and a text as `string "abc"`; only the value is kept.
        other => {
            let quoted = other.split_once('`').and_then(|(_, rest)| rest.strip_suffix('`'));
            quoted.or_else(|| other.strip_prefix("string ")).unwrap_or(other)
        }
    }
}

/// Plain words for the value that serde expects.
fn expected_text(what: &str) -> &str {
    match what {
        "a sequence" => "a list, in [ ]",
        "a string" | "string" => "a text, in double quotes",
        "usize" | "u64" | "u32" => "a whole number from 0 on",
        "i64" => "a whole number",
        "f64" => "a number",
        "a boolean" => "true or false",
        "struct variant" | "newtype variant" => "an object with its fields, such as {\"disc\": {…}}",
        "unit variant" => "the name alone",
        "an array of length 2" => "a list of 2",
        other => other.strip_prefix("struct ").map_or(other, |_| "an object, in { }"),
    }
}

/// The name between backquotes in `allowed` with the least edit distance to `name`; `None` if this distance exceeds one plus a fifth of the length of
/// `name`.
fn alike<'a>(name: &str, allowed: &'a str) -> Option<&'a str> {
    let names = allowed.split('`').skip(1).step_by(2);
    let near = names.map(|known| (slips(name, known), known)).min()?;
    (near.0 <= 1 + name.len() / 5).then_some(near.1)
}

/// The edit distance of two names: the least number of letters to insert, remove or change that turns `a` into `b`.
fn slips(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().list(), b.chars().list());
    let mut row: Vec<usize> = (0..=b.len()).list();
    for (i, x) in a.iter().enumerate() {
        let mut before = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let changed = before + usize::from(x != y);
            before = row[j + 1];
            row[j + 1] = changed.min(before + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
