//! The keys of errors, notes and messages, and of their parts.

use super::{Label, Message, Value};

keys_of_labels! {
    // app
    outline_crossed_itself, no_graphics_device, nothing_would_move, surface_too_large_to_show, image_not_in_link,
    another_answer, no_map, no_surface_from_file, open_surface_file,
    // platform
    internal_error, no_folder, browser_stores_nothing, no_page, no_canvas_for_image, size_does_not_fit,
    answer_unreadable, request_unreadable, script_not_loaded, worker_ended, worker_silent, no_page_to_draw_in, page_without_canvas, no_such_row,
    dialog_too_late,
    // geometry
    polygon_zero_area,
    // outline
    outline_file_empty, outline_file_no_path, outline_reversed, outline_closing_point_dropped, outline_upwards,
    type_not_given,
    json_null, json_truth_value, json_number, json_text, json_list, json_object, object_without_points,
    geojson_no_type, svg_elements_nested, svg_uses_nested,
    // drawing
    drawing_too_short, trace_one_colour, trace_no_shape,
    // mesh
    mesh_not_counter_clockwise, mesh_out_of_range,
    // surface
    surface_file_no_triangles, surface_note_unended, topology_empty, item_glb_version, item_file_length, item_chunk_length, item_chunk_type,
    item_json_chunk, item_default_scene, item_node, item_position, item_data, item_accessor, item_buffer_view,
    item_buffer, item_viewed_data, item_vertex, item_face, item_corner_count, item_off_keyword, item_off_number, item_vertex_count,
    item_face_count, item_list_length, item_property, item_list, item_vertex_coordinate, item_face_property,
    item_face_corner, item_element_count, item_property_element, item_format_line, item_header_end,
    item_property_name, item_triangle_count, item_triangle_normal, item_triangle_end,
    unsupported_encoding, unsupported_morphing, fault_no_glb, fault_node_twice, fault_no_ply,
    fault_list_length_type,
    // conformal
    pins_turned, map_on_boundary, map_loop_anchor_not_finite, walk_no_boundary, integral_of_surface, stays_no_curve, equation_travels_apart, integral_no_curve, integral_apart,
    integral_not_resolved, integral_singular,
    // rational
    formula_cancelled,
    // lesson
    step_own_picture, lesson_not_text, lesson_no_steps,
    // session
    link_no_session, link_damaged, link_too_much, not_carried_inexact, limit_version, limit_coordinate, limit_anchor, limit_mark,
    limit_cells, limit_picture, limit_samples, limit_growth, limit_surface_boundary, limit_weight, limit_weight_sum,
    limit_surface_anchor, choice_direction, choice_side, choice_kernel, choice_solver, choice_colouring,
    choice_texture, choice_extension, choice_comparison, choice_setting, choice_outline, choice_surface,
    // figures
    figure_no_surface, figure_no_domain, figure_outline, settled_disk_kernel_places, settled_disk_kernel_phi,
    settled_moebius_constraints, settled_moebius_lines, settled_options_outlines, settled_both_poles, settled_q_avg,
    settled_own_outlines, settled_distortion_samples, settled_distortion_constraints, settled_reshaping_samples,
    settled_crowding_x1, settled_crowding_x2, settled_crowding_precomputed, settled_crowding_zipper,
    settled_l_shapes_hemisphere, settled_l_shapes_leftmost, settled_l_shapes_others, settled_head_surface,
    settled_head_constraints, settled_head_disk, settled_face_surface, settled_face_outlines,
    settled_face_constraints, settled_convergence_constraints, settled_convergence_second_map,
    settled_convergence_zipper, scene_sixths_to_corners, scene_in_arm, scene_narrow_arms, scene_unequal_arms,
    scene_v_shape_to_blob, scene_forward, scene_backward, scene_harmonic,
    // render
    device_gone,
    // best map
    region_holds_nothing, no_shared_symmetry, limit_dabs, limit_dab_radius,
    // quadrilaterals
    quadrilateral_no_middle,
    // projections
    outline_geographic, region_no_boundary, projection_cancelled, projection_is_stereographic,
}

keys_of_messages! {
    // app
    verbatim(text); about(name, what); both_items(first, second); sentence(what); both_clauses(first, second);
    both_sentences(first, second); sentence_and(first, second); address_unknown(asked, option, known);
    address_unknown_and_more(asked, more, option, known); address_keeps(control); graphics_device_lost(reason); scene_radius(radius);
    planar_map_format(format); bare_triangles(name); not_saved(name, reason); last_session_not_opened(reason); link_not_opened(reason);
    link_misses_outline(side, name); session_not_kept(reason); files_not_kept(reason); only_session_kept(reason); pasted_text_not_shown(reason, bytes, limit);
    disk_stands_in(side, name); surface_not_in_link(name); link_copied_but(reasons); grey_in_colours(what); open_in_picture(what);
    preparation_stopped(reason); session_not_saved(reason); no_link_to_session(reason); no_window(cause);
    surface_travels_as_file(name); surface_preparation_stopped(reason); no_disk_coordinates(side, reason);
    through_disk_fails(side, reason); file_unreadable(cause); reading_stopped(reason);
    // platform
    no_image(cause); too_long_to_store(characters); no_dialog(reason); not_shared(reason); link_too_long_for_code(bytes, limit);
    link_lacks(reasons);
    // geometry
    polygon_too_few_points(count); polygon_too_many_points(limit, count); polygon_not_finite(index, x, y);
    polygon_too_far_out(index, x, y, limit); polygon_too_small(extent, limit);
    polygon_repeated_point(first, second, x, y); polygon_folds_back(index, x, y);
    polygon_edges_cross(x, y, first, second); polygon_edges_touch(x, y, first, second);
    // outline
    outline_file_too_large(bytes, limit); outline_file_not_utf8(offset); outline_file_json(message, line, column);
    outline_file_number_out_of_range(line, column); outline_file_not_a_number(found, line, column);
    outline_file_missing_number(line, column); outline_file_numbers_on_line(count, line);
    outline_file_not_understood(text, line); outline_file_reference_system(name); outline_file_no_parts(wanted);
    outline_file_no_such_number(wanted, count); outline_file_no_such_part(wanted, count, names);
    outline_shape_taken(number, count); outline_named_shape_taken(number, count, name);
    outline_repeated_points_dropped(count); outline_columns_dropped(count); lists_of_different_length(x, y);
    outline_file_odd_numbers(count); outline_file_not_a_point(point, found); outline_file_not_an_outline(found);
    outline_file_geo_json(message); outline_file_ring_not_closed(ring, x, y, end_x, end_y); outline_file_svg(message);
    outline_file_no_closed_path(paths); sampling_too_few(count); sampling_too_many(limit, count);
    sampling_more_corners_than_samples(corners, count); outline_file_no_polygon(kind); outline_largest_of(rings);
    outline_repaired(count); outline_holes_ignored(count); point_is(kind); point_has_no_number(kind);
    points_are(kind); geojson_no_list(key, kind); geojson_missing(key); geojson_polygon(kind); geojson_ring(kind);
    geojson_unknown_type(name); geojson_empty_ring(ring); point_has_numbers(count);
    // drawing
    drawing_too_few_points(count); drawing_last_handles(least);
    // mesh
    mesh_self_crossing(x, y); mesh_repeated_point(x, y); mesh_too_few_points(count); mesh_not_finite(index);
    mesh_grading(grading); mesh_too_many_vertices(estimate, limit); mesh_too_thin(x, y);
    // laplace
    laplace_structure(reason); laplace_degenerate(x, y); laplace_degenerate_at(vertex);
    laplace_not_positive_definite(vertex); laplace_too_large(unknowns, megabytes); not_converged(residual);
    // surface
    surface_file_too_large(bytes, limit); surface_file_too_much_memory(triangles, vertices, needed, available);
    surface_file_unknown_format(extension); surface_file_not_a_number(place, found);
    surface_file_missing(place, what);
    surface_file_index_out_of_range(vertices, place, index);
    surface_file_unsupported(place, what); surface_note_triangulated(polygons); surface_note_welded(before, after);
    surface_note_left_apart(vertices); surface_note_dropped_faces(count); surface_note_surplus(place); topology_index_out_of_range(vertices, triangle, vertex);
    topology_not_finite(count, vertex, limit); topology_too_small(extent, limit);
    topology_repeated_corner(count, triangle, corners); topology_degenerate(count, triangle, corners);
    topology_duplicates(count, triangle, corners, other); topology_non_manifold_edge(count, start, end, triangles);
    topology_orientation(count, start, end, left, right); topology_one_sided(triangle);
    topology_non_manifold_vertex(count, vertex, fans); topology_closed(genus);
    topology_genus(genus); repair_dropped_triangles(count); repair_dropped_duplicates(count); repair_merged_vertices(count);
    repair_flipped_flat(count); repair_split_vertices(count); repair_joined(count); repair_oriented(count);
    repair_kept_largest(dropped, components); repair_dropped_vertices(count); surface_file_malformed(place, fault);
    topology_components(count, sizes, first); topology_several(count, faults); topology_fault(number, fault); topology_loops(count, loops); topology_no_loop(count, loops, asked); topology_flat_hole(count, hole);
    boundary_loop(length, vertices, first);
    repair_filled_hole(triangles); repair_filled_holes(holes, triangles); place_line(line); place_byte(offset);
    item_element(index, count); item_corner(index, count); item_vertex_property(name);
    item_triangle_corner(triangle, count); item_named_coordinate(name); unsupported_version(version);
    unsupported_separate_file(name); unsupported_extension(name); unsupported_dimensions(keyword); fault_no_gltf(message); fault_mode(mode);
    fault_base64(position); fault_list_length(length); fault_unknown_word(word); fault_unknown_format(format);
    fault_no_type(word); fault_count(what, found); fault_accessor_type(found, component, needed); item_chunk(length);
    fault_corner_count(count);
    // conformal
    map_point_outside(side, x, y); map_anchor_not_finite(side);
    table_too_large(rows, columns, megabytes, allowed, fitting_samples);
    map_no_point(triangles, a, b, c, triangle); map_other_kind(side);
    map_no_measure(edges); map_negative_kernel(edges); walk_start_outside(x, y);
    pin_count(count, most); pin_not_finite(pin, side); pins_coincide(first, second, side);
    pins_out_of_order(first, second, third); pins_not_found(side); pin_missed(pin, miss);
    map_not_converged(side, reason); map_boundary_integral(side, reason);
    integral_too_large(needed, limit); integral_too_much_memory(limit);
    integral_corner_not_resolved(x, y); integral_not_inside(x, y); integral_not_meshed(reason);
    stays_few_points(count); stays_many_corners(corners, count); stays_leaves_edge(x, y); stays_crosses_itself(x, y);
    stays_path_crosses(x, y);
    // rational
    formula_of_surface(side); formula_finite_elements(side, reason); formula_no_integral(side);
    formula_no_digit(degree, forward, inverse);
    // zipper
    zipper_too_few_points(count); zipper_not_finite(index); zipper_repeated(index); zipper_point_outside(x, y);
    // lesson
    step_misses_outline(name, side); step_surface_file(name); step_long_caption(length, limit); lesson_too_large(limit);
    no_lesson(ours); lesson_version(found, ours); lesson_line(line); lesson_too_many_steps(limit);
    lesson_long_title(length, limit); lesson_step(step, error); lesson_step_at(step, line, error);
    lesson_too_long_for_link(limit);
    // session
    age_minutes(count); age_hours(count); age_days(count);
    session_file_damaged(reason); session_file_part_missing(part); session_file_part_broken(part, reason);
    session_file_part_too_large(part, limit); session_file_parts(limit); session_file_in_part(part, error);
    session_file_too_large(limit); session_file_malformed(reason); session_file_no_session(ours);
    session_file_version(found, ours); session_file_out_of_range(reason); session_file_outline(side, reason); session_file_pins(reason);
    link_too_long(length, limit); link_version(found, ours); link_unknown(what, name); link_out_of_range(reason);
    link_outline(side, reason); link_pins(reason); not_carried_too_long(points, limit); not_carried_not_simple(reason);
    out_of_range(what, value, low, high); outline_left_out(side, name, reason); outline_shortened(side, name, from, to, deviation);
    // render
    image_data_empty(width, height); image_data_byte_count(width, height, expected, actual); render_no_adapter(cause);
    render_no_device(adapter, cause); render_size(width, height, limit); render_viewport_count(limit, count);
    render_image(reason); render_device(reason); render_readback(reason); film_frames(frames, limit); film_rate(rate);
    film_size(width, height); film_long(pictures, limit); film_picture(width, height); film_encoder(reason);
    film_seconds(seconds, least, most); render_geometry(viewport, fault); render_surface(fault);
    too_many_triangles(count); coordinates_differ(positions, coordinates); codes_differ(triangles, codes);
    boundary_too_long(boundary, vertices); vertex_beyond(triangle, corners, vertices); too_few_bytes(width, height);
    // tiling
    tiling_out_of_range(sides, around, low, high); tiling_on_sphere(sides, around, solid); tiling_in_plane(sides, around);
    // quadrilaterals
    mark_not_finite(mark); marks_coincide(first, second); marks_out_of_order(mark, next);
    quadrilateral_too_long(a, b, c, d, length, limit);
    // projections
    point_of_ring(point, ring); region_latitude(place, latitude); region_longitude(place, longitude);
    region_too_few_points(ring, points); region_nearly_whole_sphere(clearance, limit);
    region_crosses(longitude, latitude, first, second); region_touches(longitude, latitude, first, second);
    region_no_polygon(reason); region_not_meshed(reason);
}
