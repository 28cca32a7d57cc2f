//! Parts of a text in the messages of errors.

/// The maximum number of characters of a word that a message shows.
const SHOWN_CHARACTERS: usize = 40;

/// The actual text in a message about the end of the text.
pub(crate) const END: &str = "the end of the text";

/// A word, or its beginning if it is long, quoted as in JSON.
pub(crate) fn shown(word: &str) -> String {
    let mut quoted = String::from("\"");
    for character in word.chars().take(SHOWN_CHARACTERS) {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            '\u{8}' => quoted.push_str("\\b"),
            '\0'..' ' => quoted.push_str(&format!("\\u{:04x}", u32::from(character))),
            _ => quoted.push(character),
        }
    }
    if word.chars().nth(SHOWN_CHARACTERS).is_some() {
        quoted.push('…');
    }
    quoted + "\""
}
