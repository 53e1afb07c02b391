//! Messages for sessions that cannot be opened, saved or put into a link.

use crate::language::{Label, Message, Value, key};
use crate::session::file::{self, FileError};
use crate::session::lesson::{self, LessonError, StepError};
use crate::session::link::{Choice, LeftOut, LinkError, MAX_LENGTH, NEWEST, NotCarried, ShortenedOutline, percent};
use crate::session::{OutOfRange, Quantity};

impl From<&FileError> for Message {
    fn from(error: &FileError) -> Self {
        match error {
            FileError::TooLarge { limit } => key::session_file_too_large(limit >> 20),
            FileError::Damaged(reason) => key::session_file_damaged(reason.as_str()),
            FileError::MissingPart(part) => key::session_file_part_missing(part.as_str()),
            FileError::BrokenPart { part, reason } => key::session_file_part_broken(part.as_str(), reason.as_str()),
            FileError::PartTooLarge { part, limit } => key::session_file_part_too_large(part.as_str(), limit >> 20),
            FileError::TooManyParts { limit } => key::session_file_parts(*limit),
            FileError::InPart { part, error } => key::session_file_in_part(part.as_str(), Message::from(&**error)),
            FileError::Malformed(reason) => key::session_file_malformed(reason.as_str()),
            FileError::NoSession => key::session_file_no_session(file::NEWEST),
            FileError::Version { found } => key::session_file_version(*found, file::FORMAT),
            FileError::OutOfRange(reason) => key::session_file_out_of_range(Message::from(reason)),
            FileError::Pins(reason) => key::session_file_pins(Message::from(reason)),
            FileError::Outline { side, reason } => key::session_file_outline(*side, Message::from(reason)),
        }
    }
}

impl From<&LinkError> for Message {
    fn from(error: &LinkError) -> Self {
        match error {
            LinkError::NoSession => key::link_no_session().into(),
            LinkError::TooLong { length } => key::link_too_long(*length, MAX_LENGTH),
            LinkError::Version { found } => key::link_version(found.as_str(), NEWEST),
            LinkError::Damaged => key::link_damaged().into(),
            LinkError::TooMuch => key::link_too_much().into(),
            LinkError::Unknown { what, name } => key::link_unknown(Label::from(*what), name.as_str()),
            LinkError::OutOfRange(reason) => key::link_out_of_range(Message::from(reason)),
            LinkError::Pins(reason) => key::link_pins(Message::from(reason)),
            LinkError::Outline { side, reason } => key::link_outline(*side, Message::from(reason)),
        }
    }
}

impl From<&StepError> for Message {
    fn from(error: &StepError) -> Self {
        match error {
            StepError::Link(error) => Self::from(error),
            StepError::LeftOut(outline) => Self::from(outline),
            StepError::MissingOutline { side, name } => key::step_misses_outline(name, *side),
            StepError::SurfaceFile { name } => key::step_surface_file(name),
            StepError::OwnPicture => key::step_own_picture().into(),
            StepError::LongCaption { length } => key::step_long_caption(*length, lesson::MAX_CAPTION),
        }
    }
}

impl From<&LessonError> for Message {
    fn from(error: &LessonError) -> Self {
        match error {
            LessonError::TooLarge => key::lesson_too_large(lesson::MAX_BYTES >> 10),
            LessonError::NotText => key::lesson_not_text().into(),
            LessonError::NoLesson => key::no_lesson(lesson::VERSION),
            LessonError::Version { found } => key::lesson_version(found, lesson::VERSION),
            LessonError::Line { line } => key::lesson_line(*line),
            LessonError::NoSteps => key::lesson_no_steps().into(),
            LessonError::TooManySteps => key::lesson_too_many_steps(lesson::MAX_STEPS),
            LessonError::LongTitle { length } => key::lesson_long_title(*length, lesson::MAX_TITLE),
            LessonError::Step { step, line: Some(line), error } => {
                key::lesson_step_at(*step, *line, Message::from(error))
            }
            LessonError::Step { step, line: None, error } => key::lesson_step(*step, Message::from(error)),
            LessonError::Link(error) => Self::from(error),
            LessonError::TooLongForLink => key::lesson_too_long_for_link(MAX_LENGTH),
        }
    }
}

impl From<&NotCarried> for Message {
    fn from(error: &NotCarried) -> Self {
        match error {
            NotCarried::TooLong { points } => key::not_carried_too_long(*points, MAX_LENGTH),
            NotCarried::NotSimple(reason) => key::not_carried_not_simple(Message::from(reason)),
            NotCarried::Inexact => key::not_carried_inexact().into(),
        }
    }
}

impl From<&LeftOut> for Message {
    fn from(LeftOut { side, name, reason }: &LeftOut) -> Self {
        key::outline_left_out(*side, name, Message::from(reason))
    }
}

impl From<&ShortenedOutline> for Message {
    fn from(ShortenedOutline { side, name, from, to, deviation }: &ShortenedOutline) -> Self {
        key::outline_shortened(*side, name, *from, *to, Value::number(percent(*deviation)))
    }
}

impl From<&OutOfRange> for Message {
    fn from(OutOfRange { what, value, low, high }: &OutOfRange) -> Self {
        key::out_of_range(Label::from(*what), *value, *low, *high)
    }
}

impl From<Quantity> for Label {
    fn from(quantity: Quantity) -> Self {
        match quantity {
            Quantity::Version => key::limit_version(),
            Quantity::Coordinate => key::limit_coordinate(),
            Quantity::Anchor => key::limit_anchor(),
            Quantity::Mark => key::limit_mark(),
            Quantity::Cells => key::limit_cells(),
            Quantity::Picture => key::limit_picture(),
            Quantity::Dabs => key::limit_dabs(),
            Quantity::DabRadius => key::limit_dab_radius(),
            Quantity::Samples => key::limit_samples(),
            Quantity::Growth => key::limit_growth(),
            Quantity::SurfaceBoundary => key::limit_surface_boundary(),
            Quantity::Weight => key::limit_weight(),
            Quantity::WeightSum => key::limit_weight_sum(),
            Quantity::SurfaceAnchor => key::limit_surface_anchor(),
        }
    }
}

impl From<Choice> for Label {
    fn from(choice: Choice) -> Self {
        match choice {
            Choice::Direction => key::choice_direction(),
            Choice::Extension => key::choice_extension(),
            Choice::Side => key::choice_side(),
            Choice::Kernel => key::choice_kernel(),
            Choice::Solver => key::choice_solver(),
            Choice::Colouring => key::choice_colouring(),
            Choice::Texture => key::choice_texture(),
            Choice::Comparison => key::choice_comparison(),
            Choice::Setting => key::choice_setting(),
            Choice::Outline => key::choice_outline(),
            Choice::Surface => key::choice_surface(),
        }
    }
}
