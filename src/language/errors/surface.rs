//! Messages for surfaces that are not disks, and for repairs.

use crate::language::{Message, Value, key};
use crate::surface::{Bracketed, LISTED, LoopReport, MAX_COORDINATE, MIN_EXTENT, RepairNote, TopologyError};

impl From<&TopologyError> for Message {
    fn from(error: &TopologyError) -> Self {
        match error {
            TopologyError::Empty => key::topology_empty().into(),
            TopologyError::IndexOutOfRange { triangle, vertex, vertices } => {
                key::topology_index_out_of_range(*vertices, *triangle, *vertex)
            }
            TopologyError::NotFinite { vertex, count } => {
                key::topology_not_finite(*count, *vertex, format!("{MAX_COORDINATE:e}"))
            }
            TopologyError::TooSmall { extent } => {
                key::topology_too_small(format!("{extent:e}"), format!("{MIN_EXTENT:e}"))
            }
            TopologyError::RepeatedCorner { triangle, corners, count } => {
                key::topology_repeated_corner(*count, *triangle, Bracketed(corners).to_string())
            }
            TopologyError::Degenerate { triangle, corners, count } => {
                key::topology_degenerate(*count, *triangle, Bracketed(corners).to_string())
            }
            TopologyError::Duplicates { triangle, corners, other, count } => {
                key::topology_duplicates(*count, *triangle, Bracketed(corners).to_string(), *other)
            }
            TopologyError::NonManifoldEdge { edge, triangles, count } => {
                key::topology_non_manifold_edge(*count, edge[0], edge[1], Bracketed(triangles).to_string())
            }
            TopologyError::Orientation { edge, triangles, count } => {
                key::topology_orientation(*count, edge[0], edge[1], triangles[0], triangles[1])
            }
            TopologyError::OneSided { triangle } => key::topology_one_sided(*triangle),
            TopologyError::NonManifoldVertex { vertex, fans, count } => {
                key::topology_non_manifold_vertex(*count, *vertex, *fans)
            }
            TopologyError::Components { triangles, first } => {
                let sizes = listed(triangles, |size| size.to_string().into());
                key::topology_components(triangles.len(), sizes, *first)
            }
            TopologyError::Closed { genus } => key::topology_closed(*genus),
            TopologyError::NoLoop { asked, loops } => {
                key::topology_no_loop(loops.len(), listed(loops, |each| each.into()), *asked)
            }
            TopologyError::Loops { loops } => key::topology_loops(loops.len(), listed(loops, |each| each.into())),
            TopologyError::FlatHole { hole, count } => key::topology_flat_hole(*count, Message::from(hole)),
            TopologyError::Genus { genus } => key::topology_genus(*genus),
            TopologyError::Several { faults } => {
                let numbered =
                    (1..).zip(faults).map(|(k, fault): (usize, _)| key::topology_fault(k, Message::from(fault)));
                let all = Message::joined(numbered, key::both_clauses).map_or_else(|| "".into(), Value::from);
                key::topology_several(faults.len(), all)
            }
        }
    }
}

impl From<&RepairNote> for Message {
    fn from(note: &RepairNote) -> Self {
        match note {
            RepairNote::DroppedTriangles { count } => key::repair_dropped_triangles(*count),
            RepairNote::MergedVertices { count } => key::repair_merged_vertices(*count),
            RepairNote::FlippedFlat { count } => key::repair_flipped_flat(*count),
            RepairNote::Joined { count } => key::repair_joined(*count),
            RepairNote::SplitVertices { count } => key::repair_split_vertices(*count),
            RepairNote::DroppedDuplicates { count } => key::repair_dropped_duplicates(*count),
            RepairNote::Oriented { count } => key::repair_oriented(*count),
            RepairNote::KeptLargest { components, dropped } => key::repair_kept_largest(*dropped, *components),
            RepairNote::DroppedVertices { count } => key::repair_dropped_vertices(*count),
            RepairNote::FilledHoles { holes, triangles } if holes.len() > 1 => {
                key::repair_filled_holes(holes.len(), *triangles)
            }
            RepairNote::FilledHoles { triangles, .. } => key::repair_filled_hole(*triangles),
        }
    }
}

impl From<&LoopReport> for Message {
    fn from(LoopReport { vertices, length, first }: &LoopReport) -> Self {
        key::boundary_loop(Value::number(format!("{length:.4}")), *vertices, *first)
    }
}

/// The first items of `all`, separated by commas; an ellipsis stands for the rest.
fn listed<T>(all: &[T], words: impl Fn(&T) -> Message) -> Value {
    let more = (all.len() > LISTED).then(|| Message::from("…"));
    let shown = all.iter().take(LISTED).map(words).chain(more);
    Message::joined(shown, key::both_items).map_or_else(|| "".into(), Value::from)
}
