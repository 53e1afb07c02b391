//! What only travels between the page and its workers: plain data as bytes, in postcard's encoding. Its reader takes a
//! third of the code that JSON's takes for the same types.

use serde::Serialize;
use serde::de::DeserializeOwned;

/// The bytes of plain data. Types with fields that may be left out or are flattened have none: a test of the type stops
/// there.
pub fn packed(value: &impl Serialize) -> Vec<u8> {
    let bytes = postcard::to_allocvec(value);
    debug_assert!(bytes.is_ok(), "a type that has no bytes: {bytes:?}");
    bytes.unwrap_or_default()
}

/// What [`packed`] was given; `None` if the bytes are not of this type.
pub fn unpacked<T: DeserializeOwned>(bytes: &[u8]) -> Option<T> {
    postcard::from_bytes(bytes).ok()
}

/// For a field whose type leaves fields out: it travels as JSON.
pub(super) mod as_json {
    use serde::de::{DeserializeOwned, Error as _};
    use serde::ser::Error as _;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub fn serialize<T: Serialize, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
        serde_json::to_string(value).map_err(S::Error::custom)?.serialize(serializer)
    }

    pub fn deserialize<'a, T: DeserializeOwned, D: Deserializer<'a>>(deserializer: D) -> Result<T, D::Error> {
        serde_json::from_str(&String::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}
