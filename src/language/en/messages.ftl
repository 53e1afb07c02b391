### Errors, notes and messages, in English. The errors of the core have the same words as its own texts.

## app

verbatim = { $text }
about = { $name }: { $what }
both_items = { $first }, { $second }
sentence = { $what }.
both_clauses = { $first }; { $second }
both_sentences = { $first } { $second }
sentence_and = { $first }. { $second }
address_unknown = The address says "{ $asked }", but { $option } knows only: { $known }.
address_unknown_and_more = The address says "{ $asked }" and { $more } more, but { $option } knows only: { $known }.
address_keeps = The page's address keeps "{ $control }" as it is.
graphics_device_lost = The graphics device was lost ({ $reason }). Start riemap again: the map and its undo steps are kept.
outline_crossed_itself = The outline crossed itself there: the last good one was kept.
no_graphics_device = There is no graphics device to draw with.
planar_map_format = a map in the plane is not written as .{ $format }, but as .svg, .csv or .obj
bare_triangles = { $name } has bare triangles: what else the surface's file has is not kept (triangle strips, free-form surfaces, buffers in other files, meshes that are placed twice, and maps between two surfaces).
nothing_would_move = nothing would move
surface_too_large_to_show = This surface is too large for the graphics device: it is mapped but not shown.
not_saved = { $name } was not saved: { $reason }
last_session_not_opened = What was kept from the last time could not be opened: { $reason }
link_not_opened = The link could not be opened: { $reason }
link_misses_outline = The link does not carry the { $side }'s outline "{ $name }": open its file there.
files_not_kept = The session is kept for the next time without its surfaces and pictures: { $reason }. Save it as a file to keep everything.
only_session_kept = The session is kept for the next time, but not its surfaces, pictures and undo steps: { $reason }. Save it as a file to keep everything.
session_not_kept = The session is not kept for the next time: { $reason }. Save it as a file instead.
pasted_text_not_shown = { $reason }. The text is not shown: it has { $bytes } bytes, and the field takes { $limit } at most
disk_stands_in = a disk stands in for the { $side }'s outline "{ $name }", which is not here
surface_not_in_link = the surface "{ $name }" is not in it and travels as a file
image_not_in_link = the image is not in it
link_copied_but = The link was copied, but { $reasons }.
grey_in_colours = { $what }: gray in the colors of distortion
open_in_picture = { $what }: only in the map; they are open in the picture and in files
preparation_stopped = The preparation stopped unexpectedly ({ $reason }). The map shown is the last one.
session_not_saved = The session was not saved: { $reason }
no_link_to_session = There is no link to this session: { $reason }
another_answer = an answer to another question
no_window = The window could not be opened: { $cause }
no_map = there is no map of this session
surface_travels_as_file = the session's surface "{ $name }" travels as a file of its own
no_surface_from_file = the session has no surface from a file
open_surface_file = This surface travels as a file of its own: open that file here, or drop it.
surface_preparation_stopped = The preparation of the surface stopped unexpectedly ({ $reason }). If it is very large, there may be too little memory. The map shown is the last one.
no_disk_coordinates = The { $side } has no disk coordinates: { $reason }.
through_disk_fails = The way through the disk fails on the { $side }: { $reason }.
file_unreadable = the file cannot be read ({ $cause })
reading_stopped = the reading stopped unexpectedly ({ $reason })

## platform

internal_error = an internal error
no_folder = there is no folder for it
no_image = this is no PNG or JPEG image that can be read ({ $cause })
browser_stores_nothing = the browser lets this page store nothing
too_long_to_store = its { $characters } characters are more than the browser lets this page store
no_page = there is no page
no_canvas_for_image = the browser has no canvas for it
size_does_not_fit = its size does not fit
answer_unreadable = its answer could not be read
request_unreadable = the request to it could not be read
worker_ended = it was terminated
worker_silent = it did not respond any more
script_not_loaded = its script could not be loaded
no_page_to_draw_in = There is no page to draw in.
page_without_canvas = The page has no canvas.
no_such_row = there is no such row
dialog_too_late = The browser did not open its dialog for files, because the click was too long ago. Press the button again.
no_dialog = The dialog for files could not be opened: { $reason }
not_shared = The link was not shared: { $reason }
link_too_long_for_code = This link has { $bytes } bytes, and a QR code holds { $limit }: copy it instead.
link_lacks = In this link, { $reasons }.

## geometry

polygon_too_few_points = an outline needs at least 3 points; this one has { $count }
polygon_too_many_points = an outline may have at most { $limit } points; this one has { $count }
polygon_not_finite = point { $index } is not finite: ({ $x }, { $y })
polygon_too_far_out = point { $index } at ({ $x }, { $y }) is too far out: coordinates up to { $limit } can be used
polygon_too_small = the outline is only { $extent } across; it must be at least { $limit }
polygon_repeated_point = points { $first } and { $second } are the same: ({ $x }, { $y })
polygon_zero_area = the outline encloses no area: all its points lie on one line
polygon_folds_back = the outline folds back onto itself at point { $index }, ({ $x }, { $y })
polygon_edges_cross = the outline crosses itself near ({ $x }, { $y }): the edge after point { $first } and the edge after point { $second }
polygon_edges_touch = the outline touches itself at ({ $x }, { $y }): the edge after point { $first } and the edge after point { $second }

## outline

outline_file_too_large = the file has { $bytes } bytes; files up to { $limit } MiB can be read
outline_file_not_utf8 = the file is not UTF-8 text: the byte at offset { $offset } does not belong there
outline_file_empty = the file is empty
outline_file_json = this is no valid JSON: { $message }, at line { $line }, column { $column }
outline_file_number_out_of_range = the number at line { $line }, column { $column } is out of range
outline_file_not_a_number = "{ $found }" at line { $line }, column { $column } is not a number
outline_file_missing_number = a number is missing at line { $line }, column { $column }
outline_file_numbers_on_line = { $count ->
    [one] line { $line } has 1 number; a point is two
   *[other] line { $line } has { $count } numbers; a point is two
}
outline_file_not_understood = line { $line } is not understood: "{ $text }"
outline_file_reference_system = the coordinates are in { $name }: convert them to longitude and latitude (EPSG:4326)
outline_file_no_parts = there is no part "{ $wanted }": the file holds a single outline
outline_file_no_such_number = there is no part "{ $wanted }": they are numbered from 1 to { $count }
outline_file_no_such_part = there is no part "{ $wanted }": they are numbered from 1 to { $count } and named { $names }
outline_shape_taken = Shape { $number } of { $count } was taken.
outline_named_shape_taken = Shape { $number } of { $count } was taken, "{ $name }".
outline_repeated_points_dropped = { $count ->
    [one] A point equal to the one before it was dropped.
   *[other] { $count } points equal to the one before them were dropped.
}
outline_columns_dropped = { $count ->
    [one] A column beside x and y was left out.
   *[other] { $count } columns beside x and y were left out.
}
lists_of_different_length = { $x } numbers in "x" and { $y } in "y"
outline_file_odd_numbers = { $count ->
    [one] this line has 1 number; a point is two
   *[other] this line has { $count } numbers, an odd number; a point is two
}
outline_file_not_a_point = point { $point } { $found }; a point is [x, y]
outline_file_not_an_outline = this JSON holds no outline ({ $found }): expected [[x, y], …], {"{"}"points": [[x, y], …]{"}"} or GeoJSON
outline_file_geo_json = this GeoJSON is malformed: { $message }
outline_file_ring_not_closed = ring { $ring } is not closed: it starts at ({ $x }, { $y }) and ends at ({ $end_x }, { $end_y })
outline_file_svg = this SVG cannot be read: { $message }
outline_file_no_path = this SVG has no path: convert texts to paths
outline_file_no_closed_path = no path of this SVG is closed ({ $paths } open)
sampling_too_few = at least 3 boundary samples are needed, not { $count }
sampling_too_many = at most { $limit } boundary samples are possible, not { $count }
sampling_more_corners_than_samples = the outline has { $corners } corners: { $count } samples are too few to keep them
outline_file_no_polygon = this GeoJSON holds no polygon (its type is { $kind })
outline_reversed = The points ran clockwise and were reversed.
outline_largest_of = Of { $rings } closed rings, the largest was taken.
outline_closing_point_dropped = The last point repeated the first one and was dropped.
outline_repaired = { $count ->
    [one] A repeated point or spike was cut off.
   *[other] { $count } points of loops and spikes were cut off.
}
outline_upwards = y points up: (x, y) of the drawing is (x, −y) here.
outline_holes_ignored = { $count ->
    [one] A hole was left out.
   *[other] { $count } holes were left out.
}
type_not_given = not given
json_null = null
json_truth_value = a truth value
json_number = a number
json_text = a text
json_list = a list
json_object = an object
point_is = is { $kind }
point_has_no_number = has { $kind } where a number should be
points_are = "points" is { $kind }
object_without_points = an object without "points"
geojson_no_list = "{ $key }" is { $kind }, not a list
geojson_missing = "{ $key }" is missing
geojson_polygon = a polygon is { $kind }, not a list
geojson_ring = a ring is { $kind }, not a list
geojson_unknown_type = "{ $name }" is no GeoJSON type
geojson_no_type = an object has no "type"
geojson_empty_ring = ring { $ring } has no points
svg_elements_nested = elements are nested too deeply
svg_uses_nested = "use" elements are nested too deeply
point_has_numbers = { $count ->
    [one] has 1 number
   *[other] has { $count } numbers
}

## drawing

drawing_too_short = this stroke is too short for an outline: draw around the shape in one go
drawing_too_few_points = { $count ->
    [one] an outline needs at least 3 points; 1 is set
   *[other] an outline needs at least 3 points; { $count } are set
}
drawing_last_handles = an outline keeps at least { $least } handles: this one cannot go
trace_one_colour = the whole picture has one color: there is no shape to trace
trace_no_shape = no shape was found in the picture: the largest one takes less than a thousandth of it

## mesh

mesh_self_crossing = the sampled boundary crosses itself near ({ $x }, { $y }): use more samples
mesh_repeated_point = two boundary samples coincide at ({ $x }, { $y })
mesh_too_few_points = a boundary needs at least 3 points; this one has { $count }
mesh_not_finite = boundary point { $index } is not finite
mesh_not_counter_clockwise = the boundary is clockwise, or encloses no area
mesh_out_of_range = the boundary's coordinates are all zero, or beyond 2^±300
mesh_grading = the growth of the triangle size has to be between 0.01 and 1, not { $grading }
mesh_too_many_vertices = this mesh would have about { $estimate } interior vertices; at most { $limit } are made: use fewer samples, or graded triangles
mesh_too_thin = the boundary is too thin near ({ $x }, { $y }) to be triangulated in double precision

## laplace

laplace_structure = the mesh is inconsistent: { $reason }
laplace_degenerate = a triangle near ({ $x }, { $y }) is too thin to have angles: use more samples, or a less narrow outline
laplace_degenerate_at = a triangle at vertex { $vertex } of the surface is too thin to have angles
laplace_not_positive_definite = the Laplacian is not positive definite at interior vertex { $vertex }: a triangle there is degenerate
laplace_too_large = the factor of { $unknowns } unknowns takes { $megabytes } MB, more than fits: use fewer samples, graded sizing, or the iterative solver
not_converged = the iterative solver did not converge: its relative residual is { $residual }

## surface

surface_file_too_large = the file has { $bytes } bytes; surfaces up to { $limit } MiB can be read
surface_file_too_much_memory = the surface has { $triangles } triangles and { $vertices } vertices, which take about { $needed } MB of memory; { $available } MB are available
surface_file_unknown_format = ".{ $extension }" is no surface format that is known: obj, ply, stl, off, gltf, glb
surface_file_not_a_number = { $place }: "{ $found }" is not a number
surface_file_missing = { $place }: { $what } is missing
surface_file_index_out_of_range = { $vertices ->
    [one] { $place }: a face names vertex { $index }, but the file has 1 vertex
   *[other] { $place }: a face names vertex { $index }, but the file has { $vertices } vertices
}
surface_file_unsupported = { $place }: { $what } cannot be read
surface_file_no_triangles = the file has no faces
surface_note_triangulated = { $polygons ->
    [one] 1 polygon was cut into triangles
   *[other] { $polygons } polygons were cut into triangles
}
surface_note_welded = { $before } corners at { $after } places were made { $after } vertices
surface_note_left_apart = { $vertices ->
    [one] 1 vertex stays apart from another one at the same place: joined, the surface would be no disk
   *[other] { $vertices } vertices stay apart from others at the same places: joined, the surface would be no disk
}
surface_note_dropped_faces = { $count ->
    [one] 1 face with fewer than 3 corners was dropped
   *[other] { $count } faces with fewer than 3 corners were dropped
}
surface_note_unended = the last line, endsolid, is missing; if the file was cut off, so is the surface
surface_note_surplus = { $place }: more follows than the file says it has; it was passed over
topology_empty = the surface has no triangles
topology_index_out_of_range = { $vertices ->
    [one] triangle { $triangle } names vertex { $vertex }, but there is 1 vertex
   *[other] triangle { $triangle } names vertex { $vertex }, but there are { $vertices } vertices
}
topology_not_finite = { $count ->
    [one] vertex { $vertex } is at no finite place that can be dealt with (up to ±{ $limit })
   *[other] { $count } vertices are at no finite place that can be dealt with (up to ±{ $limit }), the first is vertex { $vertex }
}
topology_too_small = the surface is { $extent } across: { $limit } at least can be dealt with
topology_repeated_corner = { $count ->
    [one] triangle { $triangle } { $corners } names a vertex twice: drop it
   *[other] { $count } triangles name a vertex twice, the first is triangle { $triangle } { $corners }: drop them
}
topology_degenerate = { $count ->
    [one] triangle { $triangle } { $corners } has no area: merge its corners or drop it
   *[other] { $count } triangles have no area, the first is triangle { $triangle } { $corners }: merge their corners or drop them
}
topology_duplicates = { $count ->
    [one] triangle { $triangle } { $corners } has the same corners as triangle { $other }: drop it
   *[other] { $count } triangles have the same corners as another one, the first is triangle { $triangle } { $corners }, as triangle { $other }: drop them
}
topology_non_manifold_edge = { $count ->
    [one] the edge from vertex { $start } to { $end } has more than two triangles, { $triangles }: delete all but two
   *[other] { $count } edges have more than two triangles, the first, from vertex { $start } to { $end }, the triangles { $triangles }: delete all but two at each
}
topology_orientation = { $count ->
    [one] the edge from vertex { $start } to { $end } lies between triangles of different orientation, { $left } and { $right }: orient the surface consistently
   *[other] { $count } edges lie between triangles of different orientation, the first from vertex { $start } to { $end }, between the triangles { $left } and { $right }: orient the surface consistently
}
topology_one_sided = the surface has one side only (as a Möbius strip): no orientation of triangle { $triangle } fits, cut it open
topology_non_manifold_vertex = { $count ->
    [one] vertex { $vertex } joins parts that share no edge, { $fans } fans of triangles: give each its own vertex there
   *[other] { $count } vertices join parts that share no edge, the first is vertex { $vertex } with { $fans } fans of triangles: give each its own vertex there
}
topology_closed = the surface is closed (genus { $genus }); it must have a boundary: cut it open
topology_genus = { $genus ->
    [one] the surface has 1 handle; a disk has none: cut it open
   *[other] the surface has { $genus } handles; a disk has none: cut it open
}
repair_dropped_triangles = { $count ->
    [one] 1 triangle that names a vertex twice was dropped
   *[other] { $count } triangles that name a vertex twice were dropped
}
repair_merged_vertices = { $count ->
    [one] 1 vertex was merged into its neighbor at the same place
   *[other] { $count } vertices were merged into their neighbors at the same place
}
repair_flipped_flat = { $count ->
    [one] 1 triangle without area had its longest edge flipped
   *[other] { $count } triangles without area had their longest edge flipped
}
repair_joined = { $count ->
    [one] 1 gap without area was joined
   *[other] { $count } gaps without area were joined
}
repair_split_vertices = { $count ->
    [one] 1 vertex was added where parts of the surface met in one
   *[other] { $count } vertices were added where parts of the surface met in one
}
repair_dropped_duplicates = { $count ->
    [one] 1 triangle with the same corners as another one was dropped
   *[other] { $count } triangles with the same corners as another one were dropped
}
repair_oriented = { $count ->
    [one] 1 triangle was turned round, so that all have the same orientation
   *[other] { $count } triangles were turned round, so that all have the same orientation
}
repair_kept_largest = { $dropped ->
    [one] the largest of { $components } components was kept; 1 triangle was dropped
   *[other] the largest of { $components } components was kept; { $dropped } triangles were dropped
}
repair_dropped_vertices = { $count ->
    [one] 1 vertex in no triangle was dropped
   *[other] { $count } vertices in no triangle were dropped
}
surface_file_malformed = { $place }: { $fault }
topology_components = the surface has { $count } components: keep the largest one (triangles: { $sizes }; the first outside of it is triangle { $first })
topology_several = the surface has { $count } kinds of faults: { $faults }
topology_fault = ({ $number }) { $fault }
topology_loops = the surface has { $count } boundary loops where a disk has one: fill all but the longest. These are the loops: { $loops }
topology_flat_hole = { $count ->
    [one] a hole has no area, since its vertices lie in a line: join them ({ $hole })
   *[other] { $count } holes have no area, since their vertices lie in a line: join them (the first: { $hole })
}
topology_no_loop = the surface has { $count } boundary loops ({ $loops }), not { $asked }
boundary_loop = length { $length } with { $vertices } vertices at vertex { $first }
repair_filled_hole = { $triangles ->
    [one] 1 hole was filled with 1 triangle
   *[other] 1 hole was filled with { $triangles } triangles
}
repair_filled_holes = { $holes } holes were filled with { $triangles } triangles
place_line = line { $line }
place_byte = byte { $offset }
item_glb_version = the version
item_file_length = the length of the file
item_chunk_length = the length of a chunk
item_chunk_type = the type of a chunk
item_json_chunk = the JSON chunk
item_default_scene = the default scene
item_node = the node
item_position = the attribute POSITION
item_data = the data
item_accessor = the accessor
item_buffer_view = the bufferView
item_buffer = the buffer
item_viewed_data = a part of the data that its bufferView describes
item_element = element { $index } of { $count }
item_vertex = a vertex
item_face = a face
item_corner_count = the number of corners
item_corner = corner { $index } of { $count }
item_off_keyword = the keyword OFF
item_off_number = a number of a vertex or of a color
item_vertex_count = the number of vertices
item_face_count = the number of faces
item_list_length = the length of a list
item_property = a property
item_list = a list
item_vertex_property = the property { $name } of the element vertex
item_vertex_coordinate = a coordinate of a vertex
item_face_property = the property vertex_indices of the element face
item_face_corner = a corner of a face
item_element_count = the number of elements
item_property_element = the element of a property
item_format_line = the line format
item_header_end = the line end_header
item_property_name = the name of a property
item_triangle_count = the number of triangles
item_triangle_normal = the normal of a triangle
item_triangle_corner = a corner of triangle { $triangle } of { $count }
item_triangle_end = the end of a triangle
item_named_coordinate = the coordinate { $name } of a vertex
unsupported_version = version { $version } of glTF
unsupported_separate_file = the separate file "{ $name }" (put it beside this one or drop both, use .glb, or embed it)
unsupported_extension = { $name } (decode it: gltf-transform cp in.glb out.glb)
unsupported_encoding = data that is not in base 64
unsupported_morphing = morph targets with weights (apply them in the program that made them)
unsupported_dimensions = a surface in 4 or n dimensions ({ $keyword })
fault_no_glb = a GLB file begins with glTF
fault_no_gltf = no glTF: { $message }
fault_node_twice = the node stands twice in the tree
fault_mode = unknown mode { $mode }
fault_base64 = no base 64: character { $position } of the data does not belong
fault_list_length = a list of length { $length }
fault_no_ply = a PLY file begins with the word ply
fault_unknown_word = unknown word { $word }
fault_unknown_format = unknown format { $format }
fault_no_type = "{ $word }" is no type
fault_list_length_type = the length of a list is no whole number
fault_count = { $what } is { $found }
fault_accessor_type = { $found } of component type { $component } where { $needed } was needed
item_chunk = { $length ->
    [one] a chunk of 1 byte
   *[other] a chunk of { $length } bytes
}
fault_corner_count = { $count ->
    [one] 1 corner is no triangle
   *[other] { $count } corners are no whole number of triangles
}

## conformal

map_point_outside = the { $side } point ({ $x }, { $y }) is not inside the { $side } outline as it is sampled
map_anchor_not_finite = the { $side } anchor is not a finite fraction of the arc length
table_too_large = the table of { $rows }×{ $columns } harmonic coordinates takes { $megabytes } MB, more than the { $allowed } MB it may take: about { $fitting_samples } boundary samples fit, or use the adjoint kernel, which needs no table
map_no_point = { $triangles ->
    [one] ({ $a }, { $b }, { $c }) in triangle { $triangle } is no point of the surface, which has 1 triangle
   *[other] ({ $a }, { $b }, { $c }) in triangle { $triangle } is no point of the surface, which has { $triangles } triangles
}
map_on_boundary = the surface point lies on the boundary of the surface; it must be inside
map_loop_anchor_not_finite = the surface anchor is not a finite fraction of the length of the boundary loop
map_other_kind = the { $side } point is of the other kind: a place in the plane for a surface, or a surface's for an outline
map_no_measure = { $edges ->
    [one] the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one
   *[other] the ends of { $edges } boundary edges fall together: no inner way leads there from the surface point, or too long a one
}
map_negative_kernel = { $edges ->
    [one] the ends of 1 boundary edge fall together: no inner way leads there from the surface point, or too long a one, or the kernel is negative there, as it may be without intrinsic Delaunay flips
   *[other] the ends of { $edges } boundary edges fall together: no inner way leads there from the surface point, or too long a one, or the kernel is negative there, as it may be without intrinsic Delaunay flips
}
walk_start_outside = the start ({ $x }, { $y }) of the random walks is not inside the outline as it is sampled
walk_no_boundary = a boundary of finite points is needed, at least 3 of them, no two neighbors equal
pins_turned = the outline was turned over, and the pins would run the other way around: the points determine the map
pin_count = { $count } boundary pairs are given: from three to { $most } determine a map
pin_not_finite = pin { $pin } has no place on the { $side }'s boundary
pins_coincide = pins { $first } and { $second } are one place of the { $side }'s boundary: each needs its own
pins_out_of_order = pins { $first }, { $second } and { $third } run around the two boundaries in opposite directions: a conformal map keeps their order
pins_not_found = no point of the { $side } was found from which the arcs between the pins are seen as on the other side: two pins may be too close to each other
pin_missed = the map misses pin { $pin } by { $miss }: its surroundings have a measure below rounding
map_not_converged = { $side }: { $reason }
map_boundary_integral = { $side }: { $reason }
integral_of_surface = the integral kernel is for outlines: a surface is computed with finite elements
stays_few_points = it has only { $count } points
stays_many_corners = { $corners } of its { $count } points are corners
stays_leaves_edge = the smooth curve through its points would leave the edge at ({ $x }, { $y }) by more than a quarter of its length
stays_crosses_itself = the smooth curve through its points would cross itself near ({ $x }, { $y })
stays_path_crosses = its curves cross near ({ $x }, { $y })
stays_no_curve = its pieces form no curve
equation_travels_apart = the integral equation of a side travels apart from the side
integral_no_curve = the outline's points form no curve: it has a spike
integral_apart = the outline's points do not follow its curve
integral_not_meshed = samples on the curve cannot be meshed: { $reason }
integral_too_large = the boundary needs at least { $needed } unknowns, more than the limit of { $limit }: it has too many corners, or parts too close to each other
integral_too_much_memory = the factor of the boundary's equation needs more than { $limit } MB: too many parts of the boundary lie across from each other
integral_corner_not_resolved = the boundary is not resolved next to its corner ({ $x }, { $y })
integral_not_resolved = the boundary cannot be resolved: parts of it touch, or a piece is not smooth
integral_singular = the equations of the boundary have no solution: does the boundary cross itself?
integral_not_inside = ({ $x }, { $y }) is not inside the outline

## rational

formula_of_surface = the { $side } is a surface; a formula is for two outlines
formula_finite_elements = the { $side } has no exact boundary values: { $reason }
formula_no_integral = the { $side } has no exact boundary values: the boundary integral was not computed
formula_no_digit = no rational function of degree up to { $degree } has one digit: the map's error is { $forward }, the inverse's { $inverse }
formula_cancelled = canceled

## zipper

zipper_too_few_points = at least 3 boundary points are needed, not { $count }
zipper_not_finite = boundary point { $index } is not finite
zipper_repeated = boundary point { $index } repeats the one before it
zipper_point_outside = the point ({ $x }, { $y }) is not inside the curve through the boundary points

## lesson

step_misses_outline = its link only names the outline "{ $name }" of the { $side }, which travels as a file
step_surface_file = the surface "{ $name }" comes from a file, which no link holds
step_own_picture = its pattern is an own picture, which no link holds
step_long_caption = the caption has { $length } characters where { $limit } are the most
lesson_too_large = the file is too large for a lesson: { $limit } KiB are the most
lesson_not_text = the file is not plain text (UTF-8)
no_lesson = this is not a lesson: its first line is not "riemap lesson { $ours }"
lesson_version = the lesson is of version { $found }, made by a newer riemap; this one opens version { $ours }
lesson_line = line { $line }: expected "Title: …" or the link of the first step, with #s=… in it
lesson_no_steps = the lesson has no step: a step is a line with a link, with #s=… in it, and its caption below
lesson_too_many_steps = the lesson has more than { $limit } steps
lesson_long_title = the title has { $length } characters where { $limit } are the most
lesson_step = step { $step }: { $error }
lesson_step_at = step { $step } (line { $line }): { $error }
lesson_too_long_for_link = the lesson is too long for a link, which has { $limit } characters at most: save it as a file

## session

age_minutes = { $count } min
age_hours = { $count } h
age_days = { $count } d
session_file_damaged = the file is damaged: it was cut off or changed on its way ({ $reason })
session_file_part_missing = the part "{ $part }" is missing in the file
session_file_part_broken = the part "{ $part }" of the file is damaged: { $reason }
session_file_part_too_large = the part "{ $part }" of the file is too large: { $limit } MiB are the most
session_file_parts = the file has too many parts: { $limit } are the most
session_file_in_part = the part "{ $part }" of the file cannot be read: { $error }
session_file_too_large = the file is too large for a session: { $limit } MiB are the most
session_file_malformed = this is not a session of riemap, or the file is damaged. Open another file, or the session's link instead ({ $reason })
session_file_no_session = the file is no session of riemap: there is no "riemap": { $ours } in it
session_file_version = the file is of format { $found }, made by a newer riemap; this one reads format { $ours }
session_file_out_of_range = the session cannot be used: { $reason }
session_file_pins = the session's pins cannot be used: { $reason }
session_file_outline = the session's outline of the { $side } cannot be used: { $reason }
link_no_session = this is not a link to a session: there is no #s=… in it
link_too_long = the link is too long: { $length } characters where { $limit } are the most
link_version = the link is of format { $found }, made by a newer riemap; this one opens format { $ours }
link_damaged = the link is damaged: it was cut off or changed on its way
link_too_much = the link holds more than a session can be
link_unknown = the link asks for the { $what } "{ $name }", which this version of riemap does not know
link_out_of_range = the link cannot be used: { $reason }
link_pins = the link's pins cannot be used: { $reason }
link_outline = the link's outline of the { $side } cannot be used: { $reason }
not_carried_too_long = its { $points } points take more than { $limit } characters
not_carried_not_simple = it is finer than a link can tell ({ $reason })
not_carried_inexact = it lies too far from the origin for its size
limit_version = the session's version
limit_coordinate = a coordinate of an interior point
limit_anchor = the place of a boundary point
limit_mark = the place of a mark
limit_cells = the number of cells of the texture
limit_picture = the placement of the picture
limit_samples = the number of boundary samples
limit_growth = the growth of the triangles
limit_surface_boundary = the number of boundary vertices of the surface
limit_weight = a weight of the surface's interior point
limit_weight_sum = the sum of the weights of the surface's interior point
limit_surface_anchor = the place of the surface's boundary point
choice_direction = direction
choice_side = side
choice_kernel = kernel mode
choice_solver = solver
choice_colouring = coloring
choice_texture = texture
choice_extension = extension
choice_comparison = comparison
choice_setting = setting
choice_outline = outline
choice_surface = surface
out_of_range = { $what } is { $value }; it must be from { $low } to { $high }
outline_shortened = the { $side }'s outline "{ $name }" has { $to } of its { $from } points in the link: it moves by at most { $deviation } of its size
outline_left_out = the { $side }'s outline "{ $name }" is not in the link: { $reason }. It travels as a file

## figures

figure_no_surface = the figure shows no surface
figure_no_domain = the figure shows outlines, and one of its sides is a surface
figure_outline = the outline of a scene is not a simple polygon
settled_disk_kernel_places = x = (0.6, 0.2), y = (1, 0) and m as in the caption; n follows from riemap's mesher
settled_disk_kernel_phi = φ is interpolated from the ring of vertices around x, not linearly in x's triangle
settled_moebius_constraints = constraints, grid and m as in the caption and section 3.2
settled_moebius_lines = the grid's lines are mapped point by point, 8 points between its nodes
settled_options_outlines = outlines: riemap's hand; the paper's blob
settled_both_poles = the paper gives no constraints: both poles of inaccessibility, both first boundary points
settled_q_avg = Q_avg leaves out flattened triangles (Q > 10); the table has both means
settled_own_outlines = outlines: riemap's own of these names
settled_distortion_samples = the paper gives only the last m (3200): m₁ doubles from 400
settled_distortion_constraints = the paper shows the constraints in Figure 1 only: both poles of inaccessibility, the leaf's top to the first petal's 4 % of the way round, so that neither tip nor stem goes into a notch
settled_reshaping_samples = 500 samples of the gingerbread man as in Table 1; 1000 of each target
settled_crowding_x1 = x₁ = 0.96 + 0.8432i and y₁ = 1 + i as in Figure 3
settled_crowding_x2 = the paper gives no x₂, y₂: the images of 0 and 1 under the blob's exact map
settled_crowding_precomputed = precomputed maps go through the center −i of the V and the blob's pole of inaccessibility
settled_crowding_zipper = of the paper's other algorithms the geodesic one (Zipper) is shown
settled_l_shapes_hemisphere = the hemisphere is riemap's own with m = 900 as in the caption; its triangles are uniform, so that there are more than the paper's 4800
settled_l_shapes_leftmost = leftmost: the L to whose corners six equidistant points go when the pole goes to (1, 1)/√3 of its sides; by Schwarz and Christoffel its arms are √3 − 1 of them wide
settled_l_shapes_others = the paper gives neither the other domains nor their constraints: the same L with x₁ in an arm, then two other Ls with their poles of inaccessibility; x₂ is the hemisphere's pole (in the app, the vertex farthest from the boundary), y₁ the concave corner
settled_head_surface = the paper's cow head is not part of riemap, whose own animal head stands in; --surface FILE takes another
settled_head_constraints = the paper gives no constraints: the vertex farthest from the boundary goes to x₁ = 0, 0.4 and 0.8
settled_head_disk = the disk has 1000 uniform samples
settled_face_surface = the paper's face is not part of riemap, whose own height field stands in; --surface FILE takes another
settled_face_outlines = outlines: riemap's own, with 1000 uniform samples and their corners
settled_face_constraints = the paper gives no constraints: the tip of the nose (of a file with y up the vertex of largest z) goes to the pole of inaccessibility, the top of the loop to the top of the outline
settled_convergence_constraints = constraints as in Figure 12
settled_convergence_second_map = with the exact second map only the V's error is left; with the blob sampled at m₂ = 1000, as in Figure 12, its own error bounds what can be reached
settled_convergence_zipper = Zipper runs on points of the exact curve; riemap on its preset, whose samples are compared with the nearest points of the curve
scene_sixths_to_corners = sixths to corners
scene_in_arm = x₁ in an arm
scene_narrow_arms = narrow arms
scene_unequal_arms = unequal arms
scene_v_shape_to_blob = V-shape → blob
scene_forward = forward
scene_backward = backward
scene_harmonic = harmonic

## render

image_data_empty = the image has no pixels ({ $width } × { $height })
image_data_byte_count = an RGBA image of { $width } × { $height } has { $expected } bytes, these are { $actual }
render_no_adapter = no graphics adapter found; on Linux, mesa-vulkan-drivers brings a software one ({ $cause })
render_no_device = the adapter { $adapter } gives no device: { $cause }
render_size = cannot render an image of { $width } × { $height } pixels: this device draws from 1 to { $limit } per side
render_viewport_count = a scene needs from 1 to { $limit } viewports, this one has { $count }
render_image = the texture image cannot be used: { $reason }
render_device = the graphics device reported an error: { $reason }
render_readback = the rendered pixels could not be read back: { $reason }
film_frames = { $frames ->
    [one] 1 frame: an animation has from 2 to { $limit }
   *[other] { $frames } frames: an animation has from 2 to { $limit }
}
film_rate = { $rate } frames per second: a GIF has at most 50
film_size = { $width } × { $height } pixels do not fit into a GIF
film_long = { $pictures ->
    [one] the animation is longer than { $limit } MiB after 1 picture: make it smaller or shorter
   *[other] the animation is longer than { $limit } MiB after { $pictures } pictures: make it smaller or shorter
}
film_picture = a picture of { $width } × { $height } pixels among others of another size
film_encoder = the animation cannot be encoded: { $reason }
film_seconds = { $seconds } s: an animation takes from { $least } to { $most } s
render_geometry = viewport { $viewport }: { $fault }
render_surface = surface: { $fault }
too_many_triangles = { $count } triangles do not fit on the graphics device
coordinates_differ = { $positions } positions have { $coordinates } texture coordinates
codes_differ = { $triangles } triangles have { $codes } codes
boundary_too_long = a boundary of { $boundary } vertices where there are { $vertices }
vertex_beyond = triangle { $triangle } { $corners } names a vertex beyond the { $vertices } given
device_gone = the device has gone away
too_few_bytes = fewer bytes than { $width } × { $height } pixels
scene_radius = x₁ = { $radius }

## best map

region_holds_nothing = the region holds no triangle of the mesh: it lies outside of the source, or is smaller than a triangle
limit_dabs = the number of dabs in the painted region
limit_dab_radius = the radius of a dab in the painted region
no_shared_symmetry = the outlines have no symmetry in common: no reflection each, and no rotation by the same angle

## tiling
tiling_out_of_range = { "{" }{ $sides }, { $around }{ "}" }: both numbers must be from { $low } to { $high }
tiling_on_sphere = { "{" }{ $sides }, { $around }{ "}" } lives on the sphere: it is the { $solid }. Choose larger numbers; the picture keeps its tiling
tiling_in_plane = { "{" }{ $sides }, { $around }{ "}" } lives in the plane, where such tiles fit without gaps. Choose larger numbers; the picture keeps its tiling

## quadrilaterals
quadrilateral_no_middle = no point was found that sees the sides from mark to mark apart: the quadrilateral is too narrow, or two marks are too close to each other
mark_not_finite = mark { $mark } is not a finite fraction of the boundary's length
marks_coincide = marks { $first } and { $second } are the same point
marks_out_of_order = mark { $mark } lies beyond mark { $next }: the marks are not in counter-clockwise cyclic order
quadrilateral_too_long = the side from mark { $a } to { $b } is too far from the side from mark { $c } to { $d }: the quadrilateral is { $length } or more times as long as wide, and { $limit } is the limit

## projections
outline_geographic = Longitudes and latitudes were taken as plane coordinates.
point_of_ring = point { $point } of ring { $ring }
region_latitude = { $place } has the latitude { $latitude }°: latitudes are from −90° to 90° (a point is [longitude, latitude] in degrees; convert meters first)
region_longitude = { $place } has the longitude { $longitude }°: longitudes are from −180° to 180° (up to ±360° is accepted; convert meters first)
region_too_few_points = ring { $ring } has { $points } different points in a row; a ring needs at least 3
region_no_boundary = the rings enclose no area, or the whole sphere
region_nearly_whole_sphere = the region covers almost the whole sphere: no point is more than { $clearance }° outside, and { $limit } is the limit
region_crosses = the boundary crosses itself at longitude { $longitude }°, latitude { $latitude }°: the edge after { $first } and the edge after { $second }
region_touches = the boundary touches itself at longitude { $longitude }°, latitude { $latitude }°: the edge after { $first } and the edge after { $second }
region_no_polygon = the boundary cannot be used: { $reason }
region_not_meshed = the region cannot be triangulated: { $reason }
projection_cancelled = the computation was canceled
projection_is_stereographic = The best stereographic projection was taken: the map that was fitted to a constant scale along the boundary varies more.
