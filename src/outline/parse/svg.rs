//! SVG: the shape of the largest painted area (`svg_shapes`), or the one that is asked for.
//!
//! Coordinates are those of the drawing's user space, which its `viewBox` describes, with y upwards. `usvg` resolves
//! shapes, styles, transforms and `use`; its coordinates are
//! single precision, about 1e-7 of the drawing's size, so the numbers of the path itself are taken from the document
//! where it has them (`svg_exact`). Images and external
//! files are never opened; gradients, clips, masks, markers and filters, which
//! do not change an outline, are disabled. Because `usvg` recurses over the
//! document, nesting and chains of `use` are checked against limits first.

use std::collections::{BTreeMap, BTreeSet};

use usvg::roxmltree::{Document, ParsingOptions};
use usvg::{ImageHrefResolver, Options, Tree};

use super::ring::Ring;
use super::svg_path::{Subpath, with_common_tangents};
use super::svg_shapes::{self, Page, Shape};
use super::{OutlineError, OutlineNote, PartChoice, SvgFault, part, svg_exact};
use crate::outline::flattened;

/// The largest nesting depth of elements; drawings have about 10.
const MAX_DEPTH: usize = 64;

/// The largest nesting depth of `use` references; drawings have 1 or 2.
const MAX_USE_CHAIN: usize = 4;

const MAX_NODES: u32 = 1_000_000;

/// Reads the shape with the id or the number `wanted`, or the largest one.
pub(super) fn read(text: &str, wanted: Option<PartChoice>) -> Result<Ring, OutlineError> {
    // The replacements have the same length, so that positions in messages stay correct.
    let text = text.replace("url(", "off(");
    let text = without_size(&parsed(&text)?).unwrap_or(text);
    let document = parsed(&text)?;
    check_nesting(&document)?;
    let image_href_resolver =
        ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = Options { image_href_resolver, ..Options::default() };
    let tree = Tree::from_xmltree(&document, &options).map_err(|e| failed(e.to_string()))?;
    let page = Page::of(&document, &tree);
    let shapes = svg_shapes::shapes(&tree, &page);
    let names: Vec<Option<&str>> = shapes.iter().map(Shape::name).collect();
    let called = |wanted| match wanted {
        PartChoice::Called(called) => svg_shapes::largest(&shapes, |shape| shape.name() == Some(called)),
        PartChoice::Number(_) => None,
    };
    let index = match wanted {
        Some(wanted) => called(wanted).map_or_else(|| part::find(wanted, &names), Ok)?,
        None => svg_shapes::largest(&shapes, |_| true).ok_or_else(|| match svg_shapes::path_count(&tree) {
            0 => OutlineError::NoPath,
            paths => OutlineError::NoClosedPath { paths },
        })?,
    };
    let ring = ring(&document, &shapes[index], &page, shapes[index].notes(index + 1, shapes.len()));
    Ok(Ring { parts: svg_shapes::parts(&shapes, index, &page), ..ring })
}

/// Reads the content of a path's `d` attribute. It holds no quotes or brackets.
pub(super) fn read_path_data(data: &str) -> Result<Ring, OutlineError> {
    read(&format!("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"{data}\"/></svg>"), None)
}

fn failed(message: String) -> OutlineError {
    OutlineError::Svg { fault: SvgFault::Reader(message) }
}

fn parsed(text: &str) -> Result<Document<'_>, OutlineError> {
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|e| failed(e.to_string()))
}

/// The text without the size in which a drawing with a `viewBox` is to be shown: coordinates are those of its user space,
/// not pixels. `None` if there is nothing to leave out.
fn without_size(document: &Document) -> Option<String> {
    let root = document.root_element();
    svg_shapes::view_box(document)?;
    let mut text = document.input_text().to_owned();
    let size = root.attributes().filter(|a| a.namespace().is_none() && matches!(a.name(), "width" | "height"));
    for range in size.map(|attribute| attribute.range_qname()) {
        text.replace_range(range.clone(), &"_".repeat(range.len()));
    }
    Some(text)
}

/// The outline around a shape, with the document's numbers where they are found.
fn ring(document: &Document, shape: &Shape, page: &Page, notes: Vec<OutlineNote>) -> Ring {
    let (rounded, path) = (Subpath::of(shape.path.data()), shape.path);
    let placement = svg_shapes::placement(path, page);
    let (subpaths, placement) = svg_exact::subpaths(document, path.data(), placement)
        .filter(|(subpaths, _)| subpaths.len() == rounded.len())
        .unwrap_or((rounded, placement));
    let segments = with_common_tangents(subpaths[shape.subpath].placed(placement));
    Ring { name: shape.name().map(str::to_owned), points: flattened(&segments), notes, segments, parts: None }
}

/// Checks the nesting depth of the document and of the references in it.
fn check_nesting(document: &Document) -> Result<(), OutlineError> {
    // An element's parent comes before it in document order.
    let mut depth: BTreeMap<u32, usize> = BTreeMap::new();
    let mut references: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for node in document.descendants().filter(usvg::roxmltree::Node::is_element) {
        let parent = node.parent().and_then(|p| depth.get(&p.id().get())).copied().unwrap_or(0);
        if parent >= MAX_DEPTH {
            return Err(OutlineError::Svg { fault: SvgFault::Elements });
        }
        depth.insert(node.id().get(), parent + 1);
        for target in
            node.attributes().filter(|a| a.name() == "href").filter_map(|a| a.value().trim().strip_prefix('#'))
        {
            for id in node.ancestors().filter_map(|a| a.attribute("id")) {
                references.entry(id).or_default().insert(target);
            }
        }
    }
    let mut reached: BTreeSet<&str> = references.keys().copied().collect();
    for _ in 0..MAX_USE_CHAIN {
        reached = reached.iter().filter_map(|id| references.get(id)).flatten().copied().collect();
    }
    if reached.is_empty() { Ok(()) } else { Err(OutlineError::Svg { fault: SvgFault::Uses }) }
}
