//! Refusals of the core as JavaScript errors.

use crate::error::{Error, Part};
use js_sys::{JsString, Number, RangeError};
use wasm_bindgen::JsValue;

/// A `RangeError` with the message of the core; JavaScript writes the numbers.
pub(super) fn refuse(error: Error) -> JsValue {
    let text = |part: Part| match part {
        Part::Text(text) => JsString::from(text),
        Part::Number(number) => Number::from(number)
            .to_string_with_radix(10)
            .unwrap_or_default(),
    };
    let message = error
        .parts()
        .into_iter()
        .fold(JsString::from(""), |message, part| {
            message.concat(&text(part))
        });
    RangeError::new(&String::from(message)).into()
}
