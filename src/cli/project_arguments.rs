//! The arguments of `riemap project`.

use std::path::PathBuf;

/// `riemap project REGION`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap project country.geojson --out country.svg --json
  riemap project preset:island --out island.svg --out island.csv")]
pub struct ProjectArguments {
    /// The region, a GeoJSON file in longitude and latitude (degrees), or `preset:island`, an island by formula; of
    /// several polygons the largest is taken, holes are filled. Edges are straight in longitude and latitude.
    pub region: String,
    /// The feature of the file, by its name or its number from 1 [default: all].
    #[arg(long, value_name = "N|NAME")]
    pub feature: Option<String>,
    /// Mend boundaries that touch or cross themselves by cutting off small loops, spikes and knots.
    #[arg(long)]
    pub repair: bool,
    /// Write the map to this file; may be repeated; the extension selects the format: svg (outline, graticule, lines of
    /// equal scale), csv (rows lon,lat,x,y: the boundary in order, then a lattice of longitudes and latitudes inside).
    /// x and y are in radii of the sphere, with scale 1 along the boundary.
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Print the ratios of scales and what was taken as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}
