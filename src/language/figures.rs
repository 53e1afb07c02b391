//! The paper's figures: titles, choices where the paper is silent, and labels of scenes.

use super::{Label, Message, key, preset};
use crate::conformal::{Direction, Extension};
use crate::figures::{Figure, LadderMethod, LadderShape, Method, SceneLabel};
use crate::outline::Preset;

/// A figure's title.
pub fn title(figure: Figure) -> Label {
    match figure {
        Figure::DiskKernel => key::poisson_kernel_harmonic_measure_disk(),
        Figure::Moebius => key::mobius_map_disk_exact_approximate(),
        Figure::Options => key::four_ways_map_hand_blob(),
        Figure::Distortion => key::angle_distortion_maple_leaf_cinquefoil(),
        Figure::Reshaping => key::gingerbread_man_conformally_reshaped(),
        Figure::Crowding => key::v_shape_blob_directly_through(),
        Figure::LShapes => key::hemisphere_over_l_shaped_domains(),
        Figure::Convergence => key::convergence_v_shape(),
        Figure::Head => key::angle_distortion_head_over_disk(),
        Figure::Face => key::face_over_planar_domains(),
    }
}

/// The choices made where the paper leaves a detail of the figure open.
pub fn choices(figure: Figure) -> Vec<Label> {
    match figure {
        Figure::DiskKernel => vec![key::settled_disk_kernel_places(), key::settled_disk_kernel_phi()],
        Figure::Moebius => vec![key::settled_moebius_constraints(), key::settled_moebius_lines()],
        Figure::Options => vec![key::settled_options_outlines(), key::settled_both_poles(), key::settled_q_avg()],
        Figure::Distortion => vec![
            key::settled_own_outlines(),
            key::settled_distortion_samples(),
            key::settled_distortion_constraints(),
            key::settled_q_avg(),
        ],
        Figure::Reshaping => vec![
            key::settled_own_outlines(),
            key::settled_both_poles(),
            key::settled_reshaping_samples(),
            key::settled_q_avg(),
        ],
        Figure::Crowding => vec![
            key::settled_crowding_x1(),
            key::settled_crowding_x2(),
            key::settled_crowding_precomputed(),
            key::settled_crowding_zipper(),
        ],
        Figure::LShapes => {
            vec![key::settled_l_shapes_hemisphere(), key::settled_l_shapes_leftmost(), key::settled_l_shapes_others()]
        }
        Figure::Head => vec![key::settled_head_surface(), key::settled_head_constraints(), key::settled_head_disk()],
        Figure::Face => {
            vec![key::settled_face_surface(), key::settled_face_outlines(), key::settled_face_constraints()]
        }
        Figure::Convergence => vec![
            key::settled_convergence_constraints(),
            key::settled_convergence_second_map(),
            key::settled_convergence_zipper(),
        ],
    }
}

/// The name of a method to map the V-shape to the blob.
pub fn method(method: Method) -> Label {
    match method {
        Method::Exact => key::exact(),
        Method::HarmonicMeasure => key::riemap_harmonic_measure(),
        Method::FreshZipper => key::zipper_run_x1_x2(),
        Method::PrecomputedZipper => key::zipper_once_then_mobius(),
    }
}

/// The name of a method in the plot of accuracy.
pub fn ladder_method(method: LadderMethod) -> Label {
    match method {
        LadderMethod::Integral => key::boundary_integral(),
        LadderMethod::AdjointUniform => key::finite_elements_uniform(),
        LadderMethod::AdjointDefault => key::finite_elements_graded(),
        LadderMethod::Zipper => key::zipper(),
    }
}

/// The name of an outline in the plot of accuracy.
pub fn ladder_shape(shape: LadderShape) -> Message {
    match shape {
        LadderShape::Disk => preset(Preset::Disk).into(),
        LadderShape::Ellipse => key::ellipse_4_1().into(),
        LadderShape::Square => preset(Preset::Square).into(),
        LadderShape::RoundedSquare => key::rounded_square().into(),
        LadderShape::LShape => preset(Preset::LShape).into(),
        LadderShape::Rectangle => key::rectangle_10_1().into(),
        LadderShape::VShape => preset(Preset::VShape).into(),
        LadderShape::Blob => preset(Preset::Blob).into(),
        LadderShape::Quintic => shape.title().into(),
        LadderShape::Notch => key::notch_1().into(),
        LadderShape::Clef => key::clef_200().into(),
        LadderShape::Coast => key::coast_192().into(),
    }
}

impl From<SceneLabel> for Message {
    fn from(label: SceneLabel) -> Self {
        match label {
            SceneLabel::Samples(_) | SceneLabel::SourceSamples(_) => label.to_string().into(),
            SceneLabel::Radius(radius) => key::scene_radius(radius),
            SceneLabel::Way(direction, extension) => key::both_items(way(direction), how(extension)),
            SceneLabel::Outline(outline) => preset(outline).into(),
            SceneLabel::VShapeToBlob => key::scene_v_shape_to_blob().into(),
            SceneLabel::SixthsToCorners => key::scene_sixths_to_corners().into(),
            SceneLabel::InArm => key::scene_in_arm().into(),
            SceneLabel::NarrowArms => key::scene_narrow_arms().into(),
            SceneLabel::UnequalArms => key::scene_unequal_arms().into(),
        }
    }
}

fn way(direction: Direction) -> Label {
    match direction {
        Direction::Forward => key::scene_forward(),
        Direction::Backward => key::scene_backward(),
    }
}

fn how(extension: Extension) -> Label {
    match extension {
        Extension::Harmonic => key::scene_harmonic(),
        Extension::CauchyGreen => key::cauchy_green(),
        Extension::Exact => key::exact_images(),
    }
}
