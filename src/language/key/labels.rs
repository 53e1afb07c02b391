//! The keys of labels: the texts of controls, menus, windows and tooltips.

use super::{Label, Message, Value};

keys_of_labels! {
    // bar
    smooth_tooltip, smooth, mirror, mirror_tooltip, delete, delete_tooltip, finish_editing, handles_tooltip,
    draw_around_shape_go, click_corners, click_points_along_curve, back, back_tooltip, close, close_tooltip, cancel,
    cancel_tooltip,
    // bench
    paper_machine,
    // chart
    arc_length_y_length, psi_length, exact, this_map,
    // colouring
    area_distortion, angle_distortion,
    // convergence
    boundary_samples_m, error, max, mean, convergence_about,
    // accuracy
    ladder_about, ladder_at_corners, ladder_against_finer, unknowns, unknowns_tooltip, boundary_points,
    boundary_points_tooltip, milliseconds, milliseconds_tooltip, boundary_images, ladder_outline, boundary_integral, finite_elements_uniform,
    finite_elements_graded, ellipse_4_1, rounded_square, rectangle_10_1, notch_1, clef_200, coast_192, accuracy_of_methods,
    accuracy_and_convergence,
    // invariants
    compute_invariants, invariants_explained, four_marks, four_marks_tooltip, second_point,
    second_point_tooltip, computing, conformal_radius, capacity, modulus, hyperbolic_distance, marks_not_in_order,
    outline_without_curve,
    // crowding
    riemap_harmonic_measure, zipper_run_x1_x2, zipper_once_then_mobius,
    // figures
    poisson_kernel_harmonic_measure_disk, mobius_map_disk_exact_approximate, four_ways_map_hand_blob,
    angle_distortion_maple_leaf_cinquefoil, gingerbread_man_conformally_reshaped, v_shape_blob_directly_through,
    hemisphere_over_l_shaped_domains, convergence_v_shape, angle_distortion_head_over_disk, face_over_planar_domains,
    // figures menu
    tables_tooltip, takes_a_minute, as_needed,
    // file menu
    file, link_tooltip, undo, undo_tooltip, redo, redo_tooltip, new_session, new_session_tooltip, open,
    open_session_tooltip, save_session, save_session_tooltip, copy_link, full_screen, presentation_size, desk_size,
    open_export, export_tooltip, recent_sessions, recent_tooltip,
    // files
    images, sessions, outlines_and_surfaces,
    // gallery
    saddle, crowding, gingerbread_heart, gingerbread_heart_about, square_circle, square_circle_about, polar_star,
    polar_star_about, around_corner, around_corner_about, leaf_flower, leaf_flower_about, hand_blob, hand_blob_about,
    unwound, unwound_about, gallery_crowding_about, globe_flattened, globe_flattened_about, saddle_about,
    gallery_half_torus, gallery_half_torus_about, animal_over_heart, animal_over_heart_about,
    // handles
    x1, x2, y1,
    // header
    surface, panels, fit, fit_tooltip, shapes, swap, swap_tooltip, panels_tooltip,
    open_shape_tooltip, interior_point_x1, boundary_point_y1, x2_f_x1, y2_f_y1, edit, edit_tooltip,
    // help menu
    help, language, theme, system, light, dark, system_tooltip, light_tooltip, dark_tooltip, open_gallery,
    open_gallery_tooltip, guided_tour, guided_tour_tooltip, open_keys_and_gestures, open_keys_and_gestures_tooltip,
    system_language_tooltip, open_paper_figures, open_paper_figures_tooltip,
    // layout
    plots, controls,
    // locks
    locked,
    // method
    cauchy_green_needs_plane, exact_needs_integral, harmonic, cauchy_green, exact_images, exact_images_tooltip,
    integral_kernel, adjoint_kernel, table_paper, cholesky, pcg,
    harmonic_tooltip, cauchy_green_tooltip, integral_kernel_tooltip, adjoint_kernel_tooltip, finite_elements,
    finite_elements_tooltip, surfaces_use_finite_elements, sharpening, sharpening_tooltip, error_estimate_tooltip,
    refining, refining_tooltip, unresolved_tooltip,
    interpret_auto, interpret_polygon, interpret_smooth, interpret_auto_tooltip, interpret_polygon_tooltip,
    interpret_smooth_tooltip, taken_polygon, taken_smooth, corner_tooltip, corner_mark_tooltip, smooth_mark_tooltip, table_paper_tooltip, cholesky_tooltip,
    pcg_tooltip,
    // names
    disk, square, gingerbread_man, heart, blob, v_shape, cinquefoil, maple_leaf, hand, turkey, l_shape, star, spiral,
    hemisphere, paraboloid, bent_strip, half_torus, face_like, animal_head, drawn, traced, pasted,
    // keyboard navigation
    picture_source, picture_target, x1_interior_point_source, x2_interior_point_target, y1_boundary_point_source,
    y2_boundary_point_target, probe,
    // offer
    trace_picture_tooltip, picture_texture, trace_outline, trace_silhouette, use_picture, use_picture_tooltip, choose_part, no,
    // other
    english, deutsch,
    // overlay
    through_disk_fresh, through_disk_precomputed, random_walks, disk_fresh, disk_precomputed, hits,
    // page
    graphics_lost, no_graphics,
    // paint
    sixty_equal_steps, their_images,
    // panel
    vertices, intrinsic_delaunay, back_plane, back_plane_tooltip, boundary_loops, explain_boundary_loops, choose_loop,
    holes, holes_filled, holes_filled_tooltip, holes_open, holes_open_tooltip, surface_map_tooltip, delaunay_tooltip,
    surface_direction, surface_direction_target, surfaces_direction, through_disk, random_walks_heading, this_map_had_none, under_a_hundredth_percent, clear,
    clear_tooltip, start, pause, conformal, euclidean, in_source, in_target, off, fresh, precomputed,
    conformal_tooltip, euclidean_tooltip, in_source_tooltip, in_target_tooltip, off_tooltip, fresh_tooltip,
    precomputed_tooltip, both_tooltip, through_disk_tooltip, walks_tooltip,
    // paste
    paste_kinds, paste_outline_source, paste_outline_target, use_pasted,
    // pins
    which_map, explain_which_map, by_points, by_points_tooltip, by_pins, by_pins_tooltip, add_pin, add_pin_tooltip,
    pin_misses_tooltip, pins_in_legend, explain_pin, no_more_pins, pins_do_not_play,
    // play panel
    speed, all, x1_tooltip, x2_tooltip, y1_tooltip, all_tooltip, no_plane, play_tooltip, stop_here, play,
    // plots
    log, poisson_kernel, reparameterisation, kernel, measure, reparam, poisson_kernel_tooltip,
    harmonic_measure_tooltip, reparameterisation_tooltip, log_tooltip,
    // presentation
    full_screen_tooltip, presentation_tooltip,
    // reports
    done, too_large, tables_of_paper, convergence_of_paper, setting_paper, setting_default, table_1, table_2,
    factor, with_psi, zipper, bff_paper, psi_match_x1_moves, x2_moves, extend, stage_mesh,
    // sessions
    link_copied,
    // settings
    show, unit_box, true_scale, unit_box_tooltip, true_scale_tooltip, corners, hit_corners, hit_corners_tooltip, both,
    source_heading, target_heading, ground, transparent, transparent_tooltip, dots, both_points, both_points_tooltip,
    coordinates, size, width_pixels, height_pixels, motion, duration,
    duration_tooltip, pictures, pictures_tooltip,
    // shapes
    open_file, draw_freehand, draw_freehand_tooltip, draw_lines, draw_lines_tooltip,
    draw_curve, draw_curve_tooltip, paste, paste_tooltip, trace_picture,
    // shortcuts
    mouse_fingers, drag_dot_gesture, drag_dot_gesture_about, drag_beside_dots, drag_beside_dots_about,
    wheel_two_fingers, wheel_two_fingers_about, double_click, double_click_about, drop_file, drop_file_about, keys,
    key_tab, key_tab_about, key_p, key_p_about, key_f, key_f_about, ctrl_z, ctrl_z_about, ctrl_shift_z_ctrl_y,
    ctrl_shift_z_ctrl_y_about, ctrl_s, ctrl_s_about, without_mouse, f6_shift_tab, arrow_keys_dot,
    arrow_keys_dot_about, arrow_keys_picture, arrow_keys_picture_about, space_enter, space_enter_about,
    f6_shift_tab_about, space, space_about, ctrl_e, ctrl_e_about, drawing_reshaping, d_l_c, d_l_c_about,
    enter_backspace, enter_backspace_about, key_e, key_e_about, double_click_outline, double_click_outline_about,
    n_shift_n, n_shift_n_about, arrow_keys_delete, arrow_keys_delete_about, escape, escape_about, ctrl_v,
    ctrl_v_about,
    // side panel
    map, mesh, mesh_tooltip, uv_layout, uv_grid, explain_uv, texture, choose, move_picture, move_picture_tooltip, picture_across,
    picture_across_tooltip, picture_up, picture_up_tooltip, picture_size, picture_size_tooltip, picture_turn,
    picture_turn_tooltip, whole_picture, whole_picture_tooltip, scale, samples, keep_corners, keep_corners_tooltip, as_many_as_needed,
    adaptive_samples_tooltip, growth, forward, backward, angle, area, checker, grid, polar, image, adaptive,
    uniform_paper, graded, uniform_mesh, forward_tooltip, backward_tooltip, texture_tooltip, angle_tooltip,
    area_tooltip, checker_tooltip, lines, polar_tooltip, image_tooltip, adaptive_tooltip, uniform_paper_tooltip,
    graded_tooltip, uniform_mesh_tooltip,
    // accessibility
    being_prepared, button, choice, check_box, slider, text_field, selected, not_selected, not_available,
    // status
    fps_tooltip, by_mesh, pointed_tooltip, hint_plane, hint_plane_touch, hint_surface, hint_surface_touch,
    // top bar
    riemap_tooltip, plots_tooltip, column_tooltip, share, share_link, share_by_system, qr_code, scan_code,
    // welcome
    welcome, take_tour, draw_own, open_own, close_welcome,
    // advanced
    advanced, advanced_tooltip, pattern, coloring, extension, kernel_heading, solver, explain_direction, explain_extension, explain_kernel,
    explain_solver, explain_through_disk, explain_walks, explain_interpretation, explain_resolution, explain_surface,
    explain_plots,
    // dots
    explain_x1, explain_x2, explain_y1, explain_y2,
    // tour
    harmonic_measure, harmonic_measure_in_legend, next, end, keep_picture, keep_picture_tooltip, show_again, end_tour_tooltip, map_between_two_shapes,
    map_between_two_shapes_about, angles_stay, angles_stay_about, three_freedoms, three_freedoms_about,
    harmonic_measure_about, tour_crowding_about, surfaces, surfaces_about,
    // lesson
    lesson, make_lesson, make_lesson_tooltip, lesson_about, lesson_title, lesson_caption_hint, add_step, add_step_tooltip, show_step,
    show_step_tooltip, renew_step, renew_step_tooltip, step_up, step_down, delete_step, title_changed, step_added, step_moved,
    step_deleted, lesson_replaced, lesson_changed_elsewhere, lesson_kept_own, undo_in_lesson, redo_in_lesson, lesson_is_full,
    lesson_without_steps, lesson_waits_for_outline, lesson_waits_for_export, lesson_waits_for_shapes,
    play_lesson, play_lesson_tooltip, save_lesson, save_lesson_tooltip, lesson_link, lesson_link_tooltip, open_lesson,
    open_lesson_tooltip, close_lesson, end_lesson_tooltip, lessons,
    // user error
    try_again, use_repaired, repair,
    // viewport
    drag_dot, drop_for_side,
    // widgets
    close_message, more_words, fewer_words,
    // window
    figures, swap_waits, export, gallery, keys_and_gestures, save, paper_figures,
    // request
    surface_obj_tooltip, surface_ply_tooltip, surface_glb_tooltip, mapped_ply_tooltip, mapped_glb_tooltip, surface_csv_tooltip, surface_svg_tooltip,
    animated_png, png_tooltip, animated_png_tooltip, gif_tooltip, svg_tooltip, disks_svg_tooltip, csv_tooltip, obj_tooltip, png, gif,
    svg, csv, obj, ply, glb, formula, formula_tooltip,
    // formula
    format, digits, digits_tooltip, inverse_of_f, formula_of_earlier_map,
    // words
    cauchy_green_gpu, cauchy_green_cpu, pending, pending_tooltip, size_tooltip, quality_tooltip, quality_unresolved, collapsed_area_tooltip, flipped_tooltip,
    frame_tooltip, source, target, stage_sample, stage_assemble, stage_order, stage_table, waiting_worker,
    reading, sampling_boundary, triangulating, assembling_laplacian, ordering, factoring, solved_iteratively,
    mesh_is_coarser,
    // best map
    best_map, explain_best_map, aim_area, aim_area_tooltip, aim_scale, aim_scale_tooltip, aim_region,
    aim_region_tooltip, aim_symmetry, aim_symmetry_tooltip, symmetry_of_outlines, find_best, find_best_tooltip, cancel_best_tooltip, course_tooltip, landscape,
    landscape_tooltip, landscape_of_surface, brush, brush_tooltip, brush_size, clear_region, clear_region_tooltip, paint_here,
    paint_here_tooltip, painted_here,
    region_is_empty, best_map_interrupted, best_sought, region_in_legend, value_area, value_scale, value_region,
    value_symmetry,
    // tiling
    tiling, tiling_tooltip, tiling_heading, explain_tiling, tile_sides, tile_sides_tooltip, tiles_at_corner,
    tiles_at_corner_tooltip, tiling_tiles, tiling_tiles_tooltip, tiling_edges, tiling_edges_tooltip, tiling_triangles,
    tiling_triangles_tooltip, tiling_picture, tiling_picture_tooltip, hyperbolic_tiles, hyperbolic_tiles_about, tetrahedron,
    octahedron, cube, icosahedron, dodecahedron,
    // symmetry
    symmetry, explain_symmetry, show_symmetries, show_symmetries_tooltip, no_symmetry, in_center, in_corner,
    drag_with_alt, drag_with_alt_about,
    // chains
    continue_from_target, continue_tooltip, choose_next_target,
    // quadrilaterals
    quadrilateral, explain_quadrilateral, explain_mark, quadrilateral_limit, map_onto_rectangle,
    map_onto_rectangle_tooltip, rectangle, orthogonal_grid, orthogonal_grid_tooltip, cells_along, cells_across_marks, save_grid,
    // projections
    map_projection, map_projection_tooltip, projection, explain_projection, projection_begin, open_region,
    open_region_tooltip, show_island, show_island_tooltip, island, regions, scale_ratio, stereographic_ratio, least_scale,
    feature, all_features, repair_region_tooltip, looks_geographic, project_it, project_it_tooltip, scale_lines_legend, save_projection,
}

keys_of_messages! {
    // chart
    arc_length_of_side(side);
    // figures menu
    figure_title(number, title); figure_samples_of_outline(samples); figure_boundary_of_surface(boundary);
    figure_surface_file(surface); figure_sides(source, target); figure_samples(source, target);
    // legend
    mean_of(value);
    // method
    harmonic_for_now(percent);
    // page
    stopped(reason);
    // panel
    picture_opened(name); parts_of(file); part_number(number); file_has_parts(count);
    faults_in_red(marked, unmarked); loop_in_list(number, length, vertices); loop_in_picture(number, count);
    along_boundary(count); rays(count); cells_across(count); points_collapsed(collapsed, samples);
    this_map_had(count); out_order(count); all_points_kept_apart(count); largest_difference(share);
    walks(count, shown); largest_deviation(deviation, chance);
    // pins
    pin_misses_by(miss); remove_pin(pin); pin_of_side(pin, side); accessible_pin(pin, source, target, miss);
    // play panel
    seconds_for_turn(seconds);
    // reports
    measuring_rows(count); paper_machine_and_here(machine); fitted_order(order); of_paper(column);
    // settings
    per_second(rate);
    // side panel
    invariants_of(side); mark(number); measure_of_arc(number); more_arcs(count); resolution_of(side); automatic(value); per_distance(growth);
    // interpretation
    outline_of(side); taken_for(kind, corners); corners_of(count); corner_at(number, x, y);
    // accessibility
    accessible_quality(mean, count); accessible_collapsed(share); problem(what); accessible_surface_map(surface, outline); accessible_map(source, target);
    accessible_map_of_surfaces(source, target);
    points_of_side(interior, place, boundary, percent); accessible_pointed(point, image, scale, turning);
    // status
    pointed(point, image, scale, turning); error_estimate(value); unresolved(share); unknowns_of(side, count); kernel_of(side, kernel); largest_q(value); flipped(count); collapsed_area(share); frame_parts(kernel, matching, extension); frame_times(compute, draw); fps(rate);
    // tour
    of(part, whole); probed(scale, turning);
    // lesson
    caption_of(number); caption_changed(number); step_renewed(number); lesson_refused(reason); step_refused(reason); step_added_but(reasons); lesson_not_kept(reason);
    // window
    pictures_done(done, all);
    // formula
    formula_function(name, degree, poles, error, digits); formula_reaches(name, digits, asked); formula_left_out(name);
    formula_boundary_values(name, error);
    // words
    edited_name(name); harmonic_coordinates(percent); cauchy_green_cpu_at(percent);
    sizes(boundary, interior, duration); surface_sizes_about(count, shown);
    edges_flipped(count, shown, before, after);
    // best map
    best_area(before, after, count); best_scale(before, after, count); best_region(before, after, count); best_symmetry(before, after, count);
    best_already(value, count); lowest_of_landscape(value); accessible_landscape(x, y, value);
    // tiling
    accessible_tiling(sides, around);
    // symmetry
    symmetries_of(side); symmetry_axis(angle, off); symmetry_turns(angle, off); symmetry_circle(off); more_axes(count);
    symmetry_tolerance(share); on_axis(angle); at_axis_end(angle); caught_dot(dot, place);
    // quadrilaterals
    pinned_to_corners(miss); grid_accuracy(error, angle); grid_error(error); lines_drawn(stride, side); computing_at(percent);
    modulus_uncertain(value, error); mark_of_side(mark, side); accessible_marks(side, first, second, third, fourth);
    accessible_grid(side, first, second, accuracy); save_grid_as(format);
    // projections
    ratio_at_most(value, error); place_in_degrees(longitude, latitude); graticule_steps(longitude, latitude);
    accessible_projection(name, ratio, stereographic); projection_left_out(percent, count); projection_joined(count);
    projection_mended(count); projection_holes(count); projection_overlaps(longitude, latitude); projecting(name); save_projection_as(format);
}
