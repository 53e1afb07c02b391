//! OFF: the lines of the counts and of faces.

use super::*;

#[test]
fn the_counts_of_an_off_stand_on_one_line_or_several() {
    let plain = read_surface("a.off", OFF.as_bytes()).unwrap();
    for head in [
        "COFF 4 2 5",
        "COFF\n4 2",
        "COFF\n4\n2\n5",
        "COFF 4\n2 5",
        "coff\n4 2\n5",
        "Coff\n4\n2",
        "4 2 0",
        "OFF4 2 5",
        "COFF4\n2 5",
    ] {
        let other = OFF.replace("COFF # kind\n4 2 5", head);
        assert_eq!(read_surface("a.off", other.as_bytes()).unwrap(), plain, "{head}");
    }
    let lower = OFF.replace("COFF", "off");
    assert_eq!(read_surface("surface", lower.as_bytes()).unwrap(), plain);
    for (head, error) in [
        ("OFF\n4", SurfaceError::missing(Place::Line(3), Item::FaceCount)),
        ("nOFF\n4 2 5", SurfaceError::unsupported(Place::Line(1), Unsupported::Dimensions("nOFF".into()))),
    ] {
        assert_eq!(read_surface("a.off", head.as_bytes()).unwrap_err(), error);
    }
}

#[test]
fn faces_of_off_go_on_in_the_next_lines() {
    let plain = read_surface("a.off", OFF.as_bytes()).unwrap();
    let broken = OFF.replace("3 0 1 2\n3 0 2 3 255\n", "3\n0 1 2\n3 0\n2 3 255\n");
    assert_eq!(read_surface("a.off", broken.as_bytes()).unwrap(), plain);
}

#[test]
fn comments_and_colors_may_stand_everywhere() {
    let plain = read_surface("a.off", OFF.as_bytes()).unwrap();
    let vertices = "0 0 2 9 9 9 # a\n\n1 0 2.5 8 8 8\n# b\n1 1 2 1 1 1\n0 1 2 0 0 0 # c\n";
    for faces in ["3 0 1 2 # d\n\n3 0 2 3 0.5 0.5 0.5 1\n# e\n", "3 0 1 2 3 255 0 0\n3 0 2 3\n"] {
        let text = format!("# before\nCOFF # d\n# counts\n4 2 0 # e\n{vertices}# faces\n{faces}");
        assert_eq!(read_surface("a.off", text.as_bytes()).unwrap(), plain, "{faces}");
    }
}
