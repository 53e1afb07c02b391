//! Labels and messages: keys of texts, and the arguments of messages.

use crate::mesh::{TriangleId, VertexId};
use std::borrow::Cow;

/// The key of a text without arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Label(&'static str);

impl Label {
    /// Only the functions of [`super::key`] may make labels.
    pub(super) const fn new(key: &'static str) -> Self {
        Self(key)
    }

    /// The key as written in the `.ftl` files.
    pub const fn key(self) -> &'static str {
        self.0
    }
}

/// The key of a text and its arguments. Serializable, since workers send messages.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Message {
    key: Cow<'static, str>,
    arguments: Vec<(Cow<'static, str>, Value)>,
}

impl Message {
    /// Only the functions of [`super::key`] and labels may make messages.
    pub(super) fn new(key: &'static str, arguments: Vec<(&'static str, Value)>) -> Self {
        let arguments = arguments.into_iter().map(|(name, value)| (name.into(), value)).collect();
        Self { key: key.into(), arguments }
    }

    /// The key as written in the `.ftl` files.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The arguments by their names.
    pub fn arguments(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.arguments.iter().map(|(name, value)| (name.as_ref(), value))
    }

    /// Whether `other` is this message or one of its arguments, at any depth.
    pub fn mentions(&self, other: &Self) -> bool {
        let within = |value: &Value| matches!(value, Value::Message(part) if part.mentions(other));
        self == other || self.arguments.iter().any(|(_, value)| within(value))
    }

    /// Joins several messages by `join`; `None` if there are none.
    pub fn joined(all: impl IntoIterator<Item = Self>, join: impl Fn(Self, Self) -> Self) -> Option<Self> {
        all.into_iter().reduce(join)
    }
}

impl From<Label> for Message {
    fn from(label: Label) -> Self {
        Self::new(label.0, Vec::new())
    }
}

/// Text from elsewhere, such as the operating system; the same in all languages.
impl From<&str> for Message {
    fn from(text: &str) -> Self {
        super::key::verbatim(text)
    }
}

/// Text from elsewhere, such as the operating system; the same in all languages.
impl From<String> for Message {
    fn from(text: String) -> Self {
        super::key::verbatim(text)
    }
}

/// An argument of a message.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Value {
    /// A name, or text from elsewhere.
    Text(Cow<'static, str>),
    /// A number with a decimal point, which German writes with a comma.
    Number(String),
    /// A count, on which the form of the words may depend.
    Count(i64),
    /// A message that is translated itself.
    Message(Message),
}

impl Value {
    /// A number that was formatted with a decimal point.
    pub fn number(text: String) -> Self {
        Self::Number(text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned().into())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl From<&String> for Value {
    fn from(text: &String) -> Self {
        Self::Text(text.clone().into())
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number.to_string())
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count as i64)
    }
}

impl From<u64> for Value {
    fn from(count: u64) -> Self {
        Self::Count(count as i64)
    }
}

impl From<i64> for Value {
    fn from(count: i64) -> Self {
        Self::Count(count)
    }
}

impl From<u32> for Value {
    fn from(count: u32) -> Self {
        Self::Count(count.into())
    }
}

impl From<VertexId> for Value {
    fn from(vertex: VertexId) -> Self {
        vertex.number().into()
    }
}

impl From<TriangleId> for Value {
    fn from(triangle: TriangleId) -> Self {
        triangle.number().into()
    }
}

impl From<Label> for Value {
    fn from(label: Label) -> Self {
        Self::Message(label.into())
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}
