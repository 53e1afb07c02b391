//! SVG: the first closed path in document order.
//!
//! `usvg` resolves shapes, styles, transforms and `use`; its coordinates are
//! single precision, about 1e-7 of the drawing's size, so the numbers of the path itself are taken from the document
//! where it has them (`svg_exact`). Images and external
//! files are never opened; paints, clips, masks, markers and filters, which
//! do not change an outline, are disabled. Because `usvg` recurses over the
//! document, nesting and chains of `use` are checked against limits first.

use std::collections::{BTreeMap, BTreeSet};

use usvg::roxmltree::{Document, ParsingOptions};
use usvg::{Group, ImageHrefResolver, Node, Options, Tree};

use super::ring::Ring;
use super::svg_exact;
use super::svg_path::{Subpath, with_common_tangents};
use super::{OutlineError, SvgFault};

/// The largest nesting depth of elements; drawings have about 10.
const MAX_DEPTH: usize = 64;

/// The largest nesting depth of `use` references; drawings have 1 or 2.
const MAX_USE_CHAIN: usize = 4;

const MAX_NODES: u32 = 1_000_000;

pub(super) fn read(text: &str) -> Result<Ring, OutlineError> {
    let failed = |message: String| OutlineError::Svg { fault: SvgFault::Reader(message) };
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    // The replacement has the same length, so that positions in messages stay correct.
    let text = text.replace("url(", "off(");
    let document = Document::parse_with_options(&text, options).map_err(|e| failed(e.to_string()))?;
    check_nesting(&document)?;
    let image_href_resolver =
        ImageHrefResolver { resolve_data: Box::new(|_, _, _| None), resolve_string: Box::new(|_, _| None) };
    let options = Options { image_href_resolver, ..Options::default() };
    let tree = Tree::from_xmltree(&document, &options).map_err(|e| failed(e.to_string()))?;
    first_closed_path(&document, &tree)
}

/// Reads the content of a path's `d` attribute. It holds no quotes or brackets.
pub(super) fn read_path_data(data: &str) -> Result<Ring, OutlineError> {
    read(&format!("<svg xmlns=\"http://www.w3.org/2000/svg\"><path d=\"{data}\"/></svg>"))
}

fn first_closed_path(document: &Document, tree: &Tree) -> Result<Ring, OutlineError> {
    let mut paths = 0;
    let mut stack: Vec<std::slice::Iter<Node>> = vec![children(tree.root())];
    while let Some(level) = stack.last_mut() {
        match level.next() {
            None => drop(stack.pop()),
            Some(Node::Group(group)) => stack.push(children(group)),
            Some(Node::Path(path)) => {
                paths += 1;
                let rounded = Subpath::of(path.data());
                if !rounded.iter().any(Subpath::is_closed) {
                    continue; // finding its exact numbers takes a pass over the document
                }
                let subpaths = svg_exact::subpaths(document, path.data()).unwrap_or(rounded);
                let place = |subpath: &Subpath| with_common_tangents(subpath.placed(path.abs_transform()));
                let closed = subpaths.iter().filter(|subpath| subpath.is_closed()).map(place);
                if let Some(ring) = Ring::largest_path_of(closed.collect()) {
                    let name = (!path.id().is_empty()).then(|| path.id().to_owned());
                    return Ok(Ring { name, ..ring });
                }
            }
            Some(_) => {}
        }
    }
    Err(if paths == 0 { OutlineError::NoPath } else { OutlineError::NoClosedPath { paths } })
}

fn children(group: &Group) -> std::slice::Iter<'_, Node> {
    group.children().iter()
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
