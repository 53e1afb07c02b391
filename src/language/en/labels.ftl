### What stands on the screen, in English: the words of controls, menus, windows and tooltips.

## bar

smooth_tooltip = Round the corners: coordinates spread along the outline as heat does; the area stays
smooth = Smooth
mirror = Mirror
mirror_tooltip = Exchange left and right, the two points too
delete = Delete
delete_tooltip = Take the selected handle away (Delete)
finish_editing = Done
handles_tooltip = Drag a square to reshape the outline. Double-click on the outline for another one; a right click or a long press takes one away. Arrow keys move the selected one (finely with Shift), N goes to the next; Escape ends.
draw_around_shape_go = Draw around the shape in one go
click_corners = Set the corners one by one
click_points_along_curve = Set points along the curve
back = Back
back_tooltip = Take the last point back (Backspace)
close = Close
close_tooltip = Join the last point to the first (Enter, or click the first point)
cancel = Cancel
cancel_tooltip = Draw nothing (Escape)

## bench

paper_machine = MacBook Air, Apple M3 (8 cores), 24 GB; C++, SC Toolbox in MATLAB

## chart

arc_length_y_length = arc length from y / length
psi_length = ψ · length
exact = exact
this_map = this map
arc_length_of_side = arc length from y / length, { $side }

## colouring

area_distortion = Area distortion log₂(σ₁σ₂)
angle_distortion = Angle distortion Q = σ₁/σ₂

## convergence

boundary_samples_m = boundary samples m
error = error
fitted_order = order { $order }
of_paper = { $column } (paper)
max = max
mean = mean
convergence_about = Distance of the boundary images from the exact ones, V-shape → blob; the blob is about 2 across.

## accuracy

ladder_about = Largest errors on the boundary, measured here, on one thread: of harmonic measure (solid) and of images (dashed: of the disk's boundary, on the disk, or from the V on the blob).
ladder_at_corners = Errors at the six corners, where exact values are known.
ladder_against_finer = Compared with the boundary integral with about twice the unknowns: no closed form is known.
unknowns = unknowns
unknowns_tooltip = Unknowns of the linear system; for Zipper, its points
boundary_points = boundary points
boundary_points_tooltip = Points on the boundary: samples, or nodes of the integral equation
milliseconds = milliseconds
milliseconds_tooltip = The time for an outline and one interior point
boundary_images = images
ladder_outline = Outline to measure
boundary_integral = boundary integral
finite_elements_uniform = finite elements, uniform
finite_elements_graded = finite elements, default
ellipse_4_1 = Ellipse 4:1
rounded_square = Rounded square
rectangle_10_1 = Rectangle 10×1
notch_1 = Notch of 1°
clef_200 = Clef with 200 corners
coast_192 = Coast with 192 corners
accuracy_of_methods = Accuracy of the methods
accuracy_and_convergence = Accuracy and convergence

## invariants

invariants_of = Invariants · { $side }
compute_invariants = Compute
invariants_explained = Numbers of the shape, each with an estimate of its error, from an integral equation on the boundary. No conformal map changes harmonic measure, modulus and hyperbolic distance; conformal radius and capacity grow with the shape. Harmonic measure: the chance that a random walk from the interior point first meets the boundary there. Conformal radius: the size of the derivative of the map of the unit disk onto the shape with 0 to the interior point. Capacity: the radius of the disk whose outside looks the same. Modulus: the extremal distance between the arcs from mark 1 to 2 and from mark 3 to 4. Hyperbolic distance: between the interior point and the second point, of curvature −1.
four_marks = Four marks
four_marks_tooltip = Boundary points as fractions of the boundary's length from its first point, counter-clockwise: the measures of the arcs between them, and the modulus
mark = mark { $number }
second_point = Second point
second_point_tooltip = For the hyperbolic distance
computing = computing…
conformal_radius = Conformal radius
capacity = Capacity
modulus = Modulus
hyperbolic_distance = Hyperbolic distance
measure_of_arc = Measure, arc { $number }
more_arcs = and { $count } more
marks_not_in_order = the marks must be four different points in counter-clockwise order
outline_without_curve = the outline is no curve: a spike of it is too narrow

## crowding

riemap_harmonic_measure = riemap (harmonic measure)
zipper_run_x1_x2 = Zipper, run for x₁, x₂
zipper_once_then_mobius = Zipper once, then Möbius

## figures

poisson_kernel_harmonic_measure_disk = Poisson kernel and harmonic measure on the disk
mobius_map_disk_exact_approximate = A Möbius map of the disk, exact and approximate
four_ways_map_hand_blob = Four ways to map a hand to the blob
angle_distortion_maple_leaf_cinquefoil = Angle distortion from the maple leaf to the cinquefoil
gingerbread_man_conformally_reshaped = The gingerbread man, conformally reshaped
v_shape_blob_directly_through = From the V-shape to the blob: directly, and through the disk
hemisphere_over_l_shaped_domains = The hemisphere over L-shaped domains
convergence_v_shape = Convergence on the V-shape
angle_distortion_head_over_disk = Angle distortion of a head over the disk
face_over_planar_domains = A face over planar domains

## figures menu

tables_tooltip = Tables 1 and 2 · times on this machine, beside the paper's
takes_a_minute = Takes a minute or two, in the background
as_needed = as needed
figure_title = Figure { $number } · { $title }
figure_samples_of_outline = { $samples } samples of the outline
figure_boundary_of_surface = { $boundary } boundary vertices of the surface
figure_surface_file = the surface { $surface }
figure_sides = { $source }, { $target }
figure_samples = { $source } samples of the source, { $target } of the target

## file menu

file = File
link_tooltip = The address carries everything that is set: it opens the same picture in another browser
undo = Undo
undo_tooltip = Take the last step back; a drag is one step
redo = Redo
redo_tooltip = Make it again
recent_sessions = Recent
recent_tooltip = The session as it was left, with its undo steps, surfaces and picture
new_session = New
new_session_tooltip = Begin with the first picture again; it can be undone
open = Open…
open_session_tooltip = A session from a .riemap file
save_session = Save…
save_session_tooltip = The session as a .riemap file
copy_link = Copy link
full_screen = Full screen
presentation_size = Presentation size
desk_size = Desk size
open_export = Export…
export_tooltip = Pictures, animations, vector graphics, tables, meshes

## files

images = Images
sessions = Sessions
outlines_and_surfaces = Outlines and surfaces

## gallery

saddle = Saddle
crowding = Crowding
gingerbread_heart = Gingerbread heart
gingerbread_heart_about = Every limb finds its place
square_circle = Square the circle
square_circle_about = Four corners, smoothed away
polar_star = Polar star
polar_star_about = Circles of Green's function, rays of equal chance
around_corner = Around the corner
around_corner_about = One re-entrant corner: the textbook singularity
leaf_flower = Leaf to flower
leaf_flower_about = Sharp tips into sharp cusps
hand_blob = A hand in a blob
hand_blob_about = Five fingers, each a crowded channel
unwound = Unwound
unwound_about = A long corridor: almost all of it is one boundary point of the disk
gallery_crowding_about = What a way through the disk loses, and the direct one keeps
globe_flattened = A globe, flattened
globe_flattened_about = Half a sphere over the disk: stereographic projection
saddle_about = Negative curvature over a square
gallery_half_torus = Half a torus
gallery_half_torus_about = A bent tube, opened
animal_over_heart = Animal over a heart
animal_over_heart_about = A head's texture, in any outline you like

## handles

x1 = x₁
x2 = x₂
y1 = y₁

## header

surface = Surface
panels = Panels
fit = Fit
fit_tooltip = Show all of it (double-click)
shapes = Shapes
swap = Swap
swap_tooltip = Exchange source and target
panels_tooltip = Fold the panels away, or bring them back (Tab)
open_shape_tooltip = An outline from a file (JSON, GeoJSON, SVG, CSV, text), or a surface (OBJ, PLY, STL, OFF, glTF, GLB)
interior_point_x1 = interior point x₁
boundary_point_y1 = boundary point y₁
x2_f_x1 = x₂ = f(x₁)
y2_f_y1 = y₂ = f(y₁)
edit = Edit
edit_tooltip = Reshape the outline by its handles (E)

## help menu

help = Help
language = Language
theme = Theme
system = System
light = Light
dark = Dark
system_tooltip = Light or dark, as the system is
light_tooltip = Dark ink on a light ground
dark_tooltip = Light ink on a dark ground
open_gallery = Gallery…
open_gallery_tooltip = Maps worth seeing
guided_tour = Guided tour
guided_tour_tooltip = Six pictures: what a conformal map is, and what it is held by
open_keys_and_gestures = Keys and gestures…
open_keys_and_gestures_tooltip = What keys, mouse and fingers do
system_language_tooltip = The language of the system, if it is one of these
open_paper_figures = The paper's figures…
open_paper_figures_tooltip = Its figures and tables, made anew

## layout

plots = Plots
controls = Controls

## legend

mean_of = mean { $value }

## locks

locked = The page's address keeps this as it is

## method

cauchy_green_needs_plane = Cauchy's integral is one over a boundary in the plane; a surface's is in space
exact_needs_integral = Exact images need the integral kernel on both sides: finite elements know the boundary to two or three digits only
harmonic_for_now = harmonic for now · { $percent } %
harmonic = Harmonic
cauchy_green = Cauchy–Green
exact_images = Exact
integral_kernel = Integral
adjoint_kernel = Adjoint
table_paper = Table (paper)
cholesky = Cholesky
pcg = PCG
harmonic_tooltip = The inside follows the boundary by the discrete Laplace equation: covers the other domain exactly
cauchy_green_tooltip = The inside follows by Cauchy's integral of the boundary: smooth, but the boundary may shrink or bulge
exact_images_tooltip = The mesh's images by Cauchy's integral over the boundary curves, to as many digits as the boundary; harmonic while something moves
integral_kernel_tooltip = Harmonic measure from an integral equation on the boundary's curve: ten digits and more. Finite elements are shown until its matrix is factored
adjoint_kernel_tooltip = Harmonic measure by finite elements, two to three digits: one solve with the transposed system for each new interior point
finite_elements = finite elements
finite_elements_tooltip = The integral kernel is not available here:
surfaces_use_finite_elements = A surface has no boundary curve in the plane: its side uses finite elements
sharpening = sharpening…
sharpening_tooltip = The map by finite elements is shown while the boundary's integral equation is factored
refining = refining…
refining_tooltip = The mesh is refined where images are long; the coarser map is shown meanwhile
unresolved_tooltip = Hatched parts of the outline, as a share of its area: they belong to less than a millionth of the other domain's size
error_estimate_tooltip = An estimate of the largest error of an image on the boundary, in the units of its outline. It covers the conditioning at corners and is computed from identities that need no exact map. Harmonic measure itself:
unknowns_of = { $side }: integral, { $count } unknowns
kernel_of = { $side }: { $kernel }
table_paper_tooltip = The harmonic coordinates of every vertex, computed in advance as in the paper: the same numbers as with the adjoint kernel
cholesky_tooltip = A complete sparse Cholesky factor: fast, and accurate even where the measure is 1e-300
pcg_tooltip = Conjugate gradients with an incomplete factor: little memory, 15 to 300 times slower; a coarse map stands in while you drag

## interpretation

outline_of = Outline · { $side }
interpret_auto = Auto
interpret_polygon = Polygon
interpret_smooth = Smooth
interpret_auto_tooltip = The file's curve if there is one, else a smooth curve through 64 points or more, unless many of them are corners
interpret_polygon_tooltip = Straight edges between the points
interpret_smooth_tooltip = The file's curve, or a smooth curve through the points, however few, with corners where they turn sharply
taken_for = taken as { $kind }, { $corners ->
    [one] { $corners } corner
   *[other] { $corners } corners
}
taken_polygon = a polygon
taken_smooth = smooth
corners_of = Corners ({ $count })
corner_at = Corner { $number } at ({ $x }, { $y })
corner_tooltip = With a tick the outline turns here; without one it passes smoothly
corner_mark_tooltip = A corner: click to make it smooth
smooth_mark_tooltip = Smooth: click to make it a corner

## names

disk = Disk
square = Square
gingerbread_man = Gingerbread man
heart = Heart
blob = Blob
v_shape = V-shape
cinquefoil = Cinquefoil
maple_leaf = Maple leaf
hand = Hand
turkey = Turkey
l_shape = L-shape
star = Star
spiral = Spiral
hemisphere = Hemisphere
paraboloid = Paraboloid
bent_strip = Bent strip
half_torus = Half torus
face_like = Face-like
animal_head = Animal head
drawn = Drawing
traced = Traced
pasted = Pasted

## keyboard navigation

picture_source = Picture of the source
picture_target = Picture of the target
x1_interior_point_source = x₁, interior point of the source
x2_interior_point_target = x₂, interior point of the target
y1_boundary_point_source = y₁, boundary point of the source
y2_boundary_point_target = y₂, boundary point of the target
probe = circle with a cross, in the source

## offer

trace_picture_tooltip = The outline of the largest shape in a PNG or JPEG
picture_texture = The picture is the texture.
trace_outline = Trace it as outline
picture_opened = "{ $name }" is a picture.
trace_silhouette = Trace its silhouette
use_picture = Use as pattern
use_picture_tooltip = Keep both outlines and lay the picture over the one whose pattern is mapped
choose_part = Choose another
parts_of = In "{ $file }":
part_number = no. { $number }
file_has_parts = The file has { $count } parts; one of them is shown.
no = No

## other

english = English
deutsch = Deutsch

## overlay

through_disk_fresh = through the disk, fresh
through_disk_precomputed = through the disk, precomputed
random_walks = random walks
disk_fresh = disk, fresh
disk_precomputed = disk, precomputed
hits = hits

## page

graphics_lost = The browser has taken the graphics away from this page, as it does after a crash of the graphics driver, or when the computer slept. The map is kept: reload the page to go on with it.
no_graphics = riemap draws with WebGPU or WebGL 2, and this browser offers neither of them here. A current Firefox, Chrome, Edge or Safari with hardware acceleration turned on will do.
stopped = riemap has stopped because of an error in itself. Reload the page to go on. ({ $reason })

## paint

sixty_equal_steps = 60 equal steps of ω
their_images = their images

## panel

vertices = Vertices
intrinsic_delaunay = Intrinsic Delaunay
back_plane = Back to the plane
back_plane_tooltip = Show this side's outline again
boundary_loops = Boundary loops
explain_boundary_loops = This surface has several boundary loops. The one chosen here, or by a click in the picture, is mapped to the outline. The others are filled, and the map is that of the filled surface.
choose_loop = Make this loop the outline
faults_in_red = { $unmarked ->
    [0] What could not be opened, with its faults in red ({ $marked }): drag to turn it
   *[other] What could not be opened, with { $marked } of its faults in red ({ $unmarked } more are not marked): drag to turn it
}
loop_in_list = { $number }: length { $length }, { $vertices } vertices
loop_in_picture = Boundary loop { $number } of { $count }: click to make it the outline
holes = Holes
holes_filled = Filled
holes_filled_tooltip = Paint what fills the other loops: with the pattern, and gray in the colors of distortion. Saved surfaces keep their holes
holes_open = Open
holes_open_tooltip = Leave the other loops open: their filling is in the map only, not in the picture. Saved surfaces keep their holes
along_boundary = { $count } along the boundary
surface_map_tooltip = A surface's Laplacian comes from the lengths of its edges; harmonic measure on its boundary loop is matched with the other side's. Over an outline every vertex gets its place there: its texture coordinate; on another surface, a point of that
delaunay_tooltip = Edges are flipped within the surface until all cotangent weights are positive: then harmonic measure is too, and the boundary keeps its order. The surface itself stays as it is
surface_direction = Every point of the surface is mapped to the outline of the source
surface_direction_target = Every point of the surface is mapped to the outline of the target
surfaces_direction = Both surfaces are mapped to the unit disk; points at the same place in the disk correspond to each other
through_disk = Through the disk
random_walks_heading = Random walks
this_map_had_none = (this map: none)
under_a_hundredth_percent = under 0.01 %
clear = Clear
clear_tooltip = Forget all hits
start = Start
pause = Pause
rays = { $count } rays
cells_across = { $count } cells across
points_collapsed = { $collapsed } of { $samples } points collapsed
this_map_had = (this map: { $count })
out_order = { $count } out of order
all_points_kept_apart = all { $count } points kept apart
largest_difference = largest difference { $share } of the length
walks = { $count ->
    [one] { $shown } walk
   *[other] { $shown } walks
}
largest_deviation = largest deviation from ω: { $deviation } (chance: about { $chance })
conformal = Conformal
euclidean = Euclidean
in_source = In the source
in_target = In the target
off = Off
fresh = Fresh
precomputed = Precomputed
conformal_tooltip = The polar grid of the disk, on both sides: the circles are level sets of Green's function about x, the rays leave equal harmonic measure between them, the first one ends at y. To a conformal map all cells are squares
euclidean_tooltip = True circles and rays about the interior point of the side where the pattern lives
in_source_tooltip = The pattern is drawn on the source and pushed forward to the target; goes best with Backward, which fills the whole target
in_target_tooltip = The pattern is drawn on the target and pulled back to the source; goes best with Forward, which fills the whole source
off_tooltip = This map alone
fresh_tooltip = Both domains are mapped to the disk anew for every place of x₁ and x₂, by the geodesic algorithm: right, but too slow to drag, so few boundary points are used until the dots rest
precomputed_tooltip = Each domain is mapped to the disk once, for its middle; moving x is then only a Möbius map. Fast, but in long arms the disk has no digits left: points fall together or change places, and no Möbius map gets them apart
both_tooltip = Fresh and precomputed disk maps side by side: what is lost with the second and not with the first is lost to crowding
through_disk_tooltip = Why not map both outlines to a disk and go through it? On the outline that is mapped to, ticks inwards are this map's images of 60 points at equal steps of harmonic measure, ticks outwards those through the disk: where both agree, each pair makes one line. The faint dots are the images of all boundary points. A point is collapsed if no digits are left between it and the one before, and out of order if it comes out before that one
walks_tooltip = Kakutani (1944): the harmonic measure of a part of the boundary is the chance that a random walk from x₁ leaves through it. Each jump goes to a random point of the largest circle that fits. Bars: the share of the hits in each piece of the boundary; strokes across: its harmonic measure

## paste

paste_kinds = SVG path data (M 0 0 L 2 0 …), SVG, coordinates (0,0 2,0 1,3 or one point per line), JSON or GeoJSON
paste_outline_source = Paste an outline for the source
paste_outline_target = Paste an outline for the target
use_pasted = Use it

## pins

which_map = Which map
explain_which_map = A conformal map has three degrees of freedom. A point x₁ with its image x₂ and a boundary point y₁ with y₂ use them up, and so do three boundary pairs, “pins”, in the same order on both sides: each pin of the source goes exactly to the pin with its number. With more than three pins the map misses them as little as possible (least squares); each pin's miss is listed.
by_points = Points
by_points_tooltip = x₁ goes to x₂ and y₁ to y₂
by_pins = Pins
by_pins_tooltip = Three boundary points or more go to three boundary points; x₁ and x₂ follow
add_pin = Add a pin
add_pin_tooltip = Adds a pin with its present image; so does a double click on an outline. Delete removes the focused one
no_more_pins = There are 64 pins, or the images of more cannot be told apart
pins_do_not_play = Pins hold the map: choose “Points” under “Which map” to let points move
pin_misses_tooltip = The distance between the pin's image and the pin of the target, in the target's units
pins_in_legend = Pins: each goes to the one of its number
explain_pin = A boundary point that goes to the pin with the same number on the other side. Drag it along the outline; a double click on the outline adds one.
pin_misses_by = miss { $miss }
remove_pin = Remove pin { $pin }
pin_of_side = Pin { $pin } of the { $side }
accessible_pin = Pin { $pin } from { $source } % to { $target } % of the boundaries, missed by { $miss }.

## play panel

speed = Speed
all = All
x1_tooltip = The source's interior point goes around a circle that stays inside
x2_tooltip = The target's interior point goes around a circle that stays inside
y1_tooltip = The source's boundary point turns once; equal times are equal harmonic measures: the disk turns evenly
all_tooltip = All of them at once, through all maps of one domain onto the other
no_plane = This point lies on a surface: it is dragged by hand
play_tooltip = Let the points move along a loop, or stop them where they are (space)
seconds_for_turn = { $seconds } s for a turn
stop_here = Stop here
play = Play

## plots

log = log
poisson_kernel = Poisson kernel
reparameterisation = Reparameterization
kernel = Kernel
measure = Measure
reparam = Reparam.
poisson_kernel_tooltip = ψ·ℓ: how likely a random walk from x is to leave through a piece of the boundary, per piece of its length; 1 where it is as likely as anywhere
harmonic_measure_tooltip = ω: the chance that a random walk from x leaves through the boundary between y and here, counter-clockwise. The map takes each point to the one with the same measure
reparameterisation_tooltip = r: where the map takes a boundary point, in arc length from y; straight where lengths are kept in proportion
log_tooltip = A logarithmic axis: shows how deep the kernel falls where the domain is crowded

## presentation

full_screen_tooltip = The whole screen, or a window again (F)
presentation_tooltip = Text, controls, dots and lines half as large again, to be read from afar

## reports

done = done
too_large = too large
measuring_rows = { $count ->
    [one] measuring, { $count } row to go…
   *[other] measuring, { $count } rows to go…
}
paper_machine_and_here = Paper: { $machine }. Here: one thread.
tables_of_paper = Tables 1 and 2 on this machine
convergence_of_paper = Figure 15: convergence on the V-shape, up to m = 2000
setting_paper = the paper's settings: uniform samples and triangles
setting_default = riemap's defaults: adaptive samples, graded triangles
table_1 = Table 1: preparation, in seconds
table_2 = Table 2: a frame, in milliseconds
factor = factor
with_psi = with Ψ
zipper = Zipper
bff_paper = BFF, paper
psi_match_x1_moves = ψ + match, x₁ moves
x2_moves = ψ + match, x₂ moves
extend = extend
stage_mesh = mesh

## sessions

link_copied = Link copied

## settings

show = Show
unit_box = Unit box
true_scale = True scale
unit_box_tooltip = Texture coordinates are moved and scaled into the unit box
true_scale_tooltip = Texture coordinates are the outline's own
per_second = { $rate } per second
both = Both
source_heading = Source
target_heading = Target
ground = Ground
transparent = Transparent
transparent_tooltip = Without the color behind the map
corners = Corners
hit_corners = Hit exactly
hit_corners_tooltip = The surface’s boundary edges are divided where the outline’s corners lie, so that no corner stays empty. New vertices follow those of the file.
dots = Dots
both_points = Interior and boundary point
both_points_tooltip = The dots of x and y on both sides
coordinates = Coordinates
size = Size
width_pixels = Width in pixels
height_pixels = Height in pixels
motion = Motion
duration = Duration
duration_tooltip = Seconds for one loop
pictures = Pictures
pictures_tooltip = Number of pictures in one loop

## shapes

open_file = Open a file…
draw_freehand = Draw freehand
draw_freehand_tooltip = Around the shape in one stroke; corners stay corners (D)
draw_lines = Draw lines
draw_lines_tooltip = Straight edges between clicked points (L)
draw_curve = Draw a curve
draw_curve_tooltip = A smooth curve through clicked points (C)
paste = Paste…
paste_tooltip = SVG path data or coordinates; Ctrl+V anywhere is the source's
trace_picture = Trace a picture…

## shortcuts

mouse_fingers = Mouse and fingers
drag_dot_gesture = Drag a dot
drag_dot_gesture_about = Moves what the map is held by; the map follows
drag_beside_dots = Drag beside the dots
drag_beside_dots_about = Moves the picture; a surface is turned, with Shift moved
wheel_two_fingers = Wheel, or two fingers
wheel_two_fingers_about = Zooms; two fingers also move
double_click = Double-click
double_click_about = Shows all of it again; with pins, on an outline, adds one with its image
drop_file = Drop a file
drop_file_about = Opens an outline, a surface, an image or a session
keys = Keys
key_tab = Tab
key_tab_about = Folds the panels away, or brings them back
key_p = P
key_p_about = Opens and closes the plots
key_f = F
key_f_about = Fills the screen, or gives it back
ctrl_z = Ctrl+Z
ctrl_z_about = Takes a step back
ctrl_shift_z_ctrl_y = Ctrl+Shift+Z or Ctrl+Y
ctrl_shift_z_ctrl_y_about = Makes it again
ctrl_s = Ctrl+S
ctrl_s_about = Saves the session as a file
without_mouse = Without a mouse
f6_shift_tab = F6 or Shift+Tab
arrow_keys_dot = Arrow keys on a dot
arrow_keys_dot_about = Move it; with Shift finely. A magenta dot goes along its boundary; Delete removes a pin
arrow_keys_picture = Arrow keys on a picture
arrow_keys_picture_about = Move it, or turn the surface; + and − zoom, 0 shows all of it
space_enter = Space or Enter
space_enter_about = Presses a button
f6_shift_tab_about = Begins to walk through controls, pictures and dots; Tab goes on, Escape ends
space = Space
space_about = Sets the points in motion, or stops them where they are
ctrl_e = Ctrl+E
ctrl_e_about = Opens the window that saves pictures, animations and other files
drawing_reshaping = Drawing and reshaping
d_l_c = D, L, C
d_l_c_about = Draws an outline: freehand, with straight edges, as a curve; for the side under the pointer
enter_backspace = Enter, Backspace
enter_backspace_about = Closes what is drawn; takes its last point back
key_e = E
key_e_about = Reshapes the outline under the pointer by its handles, or ends that
double_click_outline = Double-click on the outline
double_click_outline_about = Sets another handle; a right click or a long press takes one away
n_shift_n = N, Shift+N
n_shift_n_about = Go to the next handle, to the one before
arrow_keys_delete = Arrow keys, Delete
arrow_keys_delete_about = Move the chosen handle, with Shift finely; take it away
escape = Escape
escape_about = Ends drawing, reshaping and the tour, and closes windows
ctrl_v = Ctrl+V
ctrl_v_about = Takes an outline from the clipboard: path data, coordinates, GeoJSON

## side panel

map = Map
mesh = Mesh
mesh_tooltip = The edges of the mapped mesh, and of its image on the other side
uv_layout = Layout
uv_grid = UV grid
explain_uv = The texture coordinates u and v that the saved surface gets, over the outline: the unit square with its axes, and the edges of holes as seams. With Mesh, the layout of its triangles. The export window chooses between unit box and true scale.
texture = Pattern
move_picture = Move it in the picture
move_picture_tooltip = Dragging moves it. Scrolling or two fingers scale it; Shift and scrolling, or turning two fingers, turn it.
picture_across = Across
picture_across_tooltip = From the middle of the outline to the right, in its larger side
picture_up = Up
picture_up_tooltip = From the middle of the outline upwards, in its larger side
picture_size = Size
picture_size_tooltip = At 100 % the whole picture fits over the outline
picture_turn = Turn
picture_turn_tooltip = Counter-clockwise, in degrees
whole_picture = Show the whole picture
whole_picture_tooltip = Upright, in the middle of the outline
choose = Choose…
scale = Scale
samples = Samples
keep_corners = Keep corners
keep_corners_tooltip = The outline's corners are samples too
as_many_as_needed = As many as the outline needs
adaptive_samples_tooltip = Spacing from curvature, corners and channel width alone
growth = Growth
resolution_of = Resolution · { $side }
automatic = { $value }, automatic
per_distance = { $growth } per distance
forward = Forward
backward = Backward
angle = Angle
area = Area
checker = Checker
grid = Grid
polar = Polar
image = Image
adaptive = Adaptive
uniform_paper = Uniform (paper)
graded = Graded
uniform_mesh = Uniform mesh
forward_tooltip = The source's mesh is mapped into the target
backward_tooltip = The target's mesh is mapped into the source and looks its texture up there
texture_tooltip = The pattern that the map carries
angle_tooltip = Angle distortion Q = σ₁/σ₂ of every triangle: 1 where angles are kept
area_tooltip = Area distortion log₂(σ₁σ₂) of every triangle, from source to target: +1 is twice the area, −1 half of it. The colors are about the mean
checker_tooltip = Squares; angles of 90° stay angles of 90°
lines = Lines
polar_tooltip = Circles and rays about the interior point
image_tooltip = Your own PNG or JPEG; drop one anywhere
adaptive_tooltip = Denser at corners, high curvature and in narrow channels: a smaller error for the same number
uniform_paper_tooltip = Equally spaced in arc length, as in the paper
graded_tooltip = Triangles grow with the distance from the boundary: 4–15 % of the vertices at nearly the same error
uniform_mesh_tooltip = Triangles of one size, as in the paper

## accessibility

accessible_quality = { $count ->
    [one] Mean angle distortion { $mean }; { $count } triangle flipped.
   *[other] Mean angle distortion { $mean }; { $count } triangles flipped.
}
accessible_collapsed = { $share } percent of the area are triangles that have no resolved image.
being_prepared = Being prepared.
problem = Problem: { $what }
accessible_surface_map = The surface { $surface }, mapped conformally to the outline { $outline }.
accessible_map_of_surfaces = Conformal map from the surface { $source } to the surface { $target }.
accessible_map = Conformal map from { $source } to { $target }.
points_of_side = { $interior } at ({ $place }), { $boundary } at { $percent } % of the boundary.
accessible_pointed = Under the pointer: { $point } goes to { $image }, scale { $scale }, turning { $turning } degrees.
button = button
choice = choice
check_box = check box
slider = slider
text_field = text field
selected = selected
not_selected = not selected
not_available = not available

## status

fps_tooltip = While something moves; at rest nothing is drawn
pointed = { $point } → { $image } · scale { $scale } · turning { $turning }°
by_mesh = mesh
pointed_tooltip = The point under the pointer, its image, and by how much the map enlarges and turns there: |f′| and arg f′. All digits are right by the estimate of the error; “mesh”: interpolated in a triangle, two or three digits
error_estimate = error { $value }
unresolved = unresolved { $share }
largest_q = largest Q: { $value }
flipped = flipped { $count }
collapsed_area = collapsed { $share } %
frame_parts = kernel { $kernel } ms + match { $matching } ms + extend { $extension } ms
frame_times = frame { $compute } ms + draw { $draw } ms
fps = { $rate } fps
hint_plane = scroll to zoom · drop a file anywhere
hint_surface = drag the surface to turn it · shift moves it · scroll to zoom
hint_plane_touch = pinch to zoom · tap a point for its image
hint_surface_touch = drag the surface to turn it · two fingers move it · pinch to zoom

## advanced

advanced = Advanced
advanced_tooltip = Direction, method, comparisons, resolution, invariants
pattern = Pattern
coloring = Coloring
extension = Extension
kernel_heading = Kernel
solver = Solver
explain_direction = Which side is cut into triangles and carried over. Backward: each point of the target looks up its place in the source, which keeps the pattern sharp. Forward: the triangles of the source are moved to the target.
explain_extension = The map is found on the boundary first. The extension carries it on into the inside, in one of three ways.
explain_kernel = The kernel says how much each piece of the boundary counts, seen from x: the chance that a random walk from x ends there. The integral works on the boundary itself and is exact to many digits; the others work on the triangles.
explain_solver = How the many linear equations on the triangles are solved: all at once (Cholesky), or step by step with little memory (PCG).
explain_through_disk = The usual way maps both figures to a round disk and goes through it. Long arms shrink to nothing there. Switch it on to see what that way loses and the direct map keeps.
explain_walks = Points that wander at random from x₁ until they meet the boundary. How many end on a piece of it is its harmonic measure: the walks check the numbers that the map is made from.
explain_interpretation = Whether straight edges or a smooth curve join the points of the outline, and which of the points are corners.
explain_resolution = How many points the boundary gets, and how quickly the triangles grow towards the middle. More points are finer and slower.
explain_surface = How finely the surface is divided. Intrinsic Delaunay triangles make its numbers reliable and leave its shape alone.
explain_plots = Three curves along the boundary: how strongly each piece counts (Poisson kernel), the running sum of that (harmonic measure), and which place of the one boundary goes to which of the other (reparameterization).

## dots

explain_x1 = x₁: a point inside the source. The map carries it to x₂. Drag it: the target follows.
explain_x2 = x₂ = f(x₁): the point inside the target to which the map carries x₁. Drag it to choose another one.
explain_y1 = y₁: a point on the boundary of the source. The map carries it to y₂. Drag it along the boundary: the inside turns about x₁.
explain_y2 = y₂ = f(y₁): the point on the boundary of the target to which the map carries y₁. Drag it along the boundary.

## welcome

welcome = riemap reshapes one figure into another, and every angle stays as it is.
take_tour = Take the tour
draw_own = Draw your own
open_own = Open a file or surface
close_welcome = Close the welcome

## top bar

riemap_tooltip = The conformal map between two outlines, by matching harmonic measure
column_tooltip = Fold the controls away, or bring them back (Tab: everything)
share = Share
share_link = Share…
share_by_system = Share…
qr_code = The link as a QR code
scan_code = Point a camera at it: the phone opens this map.
plots_tooltip = Poisson kernel, harmonic measure and reparameterization along the boundaries (P)

## tour

harmonic_measure = Harmonic measure
harmonic_measure_in_legend = harmonic measure
of = { $part } of { $whole }
next = Next
end = End
keep_picture = Keep this picture
keep_picture_tooltip = Ends here, and this picture stays
show_again = Again
end_tour_tooltip = Ends the tour and shows your own picture again
map_between_two_shapes = A map between two shapes
map_between_two_shapes_about = Whatever is drawn inside one outline is carried into the other one: stretched and turned from place to place, but never torn and never folded. x₁ goes once around, and all of it follows. Then drag a green dot.
angles_stay = Angles stay
angles_stay_about = That is what conformal means. The small circle becomes a circle again, larger or smaller (by |f′|) and turned, and the right angle in it stays one. Drag the circle: this is so everywhere, the better the smaller the circle.
three_freedoms = Three freedoms
three_freedoms_about = Riemann (1851): between two such outlines there is exactly one conformal map once you say where one inner point goes (two numbers, the green dots) and where one boundary point goes (one number, the magenta dots). See them move: x₁, then x₂, then y₁.
harmonic_measure_about = Let a random walk start at the green dot. The chance that it leaves through a part of the boundary is that part's harmonic measure. A conformal map keeps it, so it is enough to match it along both boundaries: that is how riemap computes.
tour_crowding_about = Why not go through a disk? From this V, arms shrink on the disk's rim to lengths of 10⁻¹⁷, and the computer has no digits left: on the blob, the marks outside of the outline have run together. Those inside are matched directly, and stay apart.
surfaces = Surfaces
probed = |f′| = { $scale }, turned by { $turning }°
surfaces_about = The same works for a surface in space with one boundary: each of its points gets a place in the outline. y₁ goes once around the outline, and the pattern runs over the head. Then turn the head, or drag the dots on it. This is how textures are laid on models.

## user error

try_again = Try again
use_repaired = Use it repaired
repair = Repair it

## viewport

drag_dot = drag a dot
drop_for_side = Drop an outline (SVG, JSON, CSV) or a mesh (OBJ, PLY, STL, glTF) for this side, or a picture (PNG, JPEG) as the texture

## widgets

close_message = Close this message
more_words = More
fewer_words = Less

## window

figures = Figures
swap_waits = While nothing is prepared
export = Export
gallery = Gallery
keys_and_gestures = Keys and gestures
pictures_done = { $done } of { $all } pictures
save = Save
paper_figures = The paper's figures

## request

surface_obj_tooltip = Wavefront OBJ: the vertices in their order, each with its texture coordinate; an OBJ file keeps everything else
surface_ply_tooltip = PLY: x y z s t for each vertex; a PLY file keeps everything else
surface_glb_tooltip = Binary glTF with texture coordinates; a glTF file keeps materials and images
mapped_ply_tooltip = PLY, ascii: each vertex in the target, and where it lies in the source
mapped_glb_tooltip = Binary glTF: the mesh in the target, its places in the source as _SOURCE
surface_csv_tooltip = A table: x, y, z, u, v for each vertex
surface_svg_tooltip = The edges of the layout in the outline
animated_png = Animated PNG
png_tooltip = The picture, of any size
animated_png_tooltip = A turn of the points that goes on for ever, in all its colors
gif_tooltip = A turn of the points that goes on for ever, in 256 colors
svg_tooltip = Outlines, the pattern's lines, the points, and the mesh where it is shown
disks_svg_tooltip = Both surfaces as they lie in the unit disk, with the lines of the pattern, the points, and the meshes where they are shown
csv_tooltip = A table of boundary points that are mapped to each other: arc lengths, places, harmonic measure
obj_tooltip = Wavefront OBJ: the mesh in the target, its texture coordinates in the source
png = PNG
gif = GIF
svg = SVG
csv = CSV
obj = OBJ
ply = PLY
glb = GLB
formula = Formula
formula_tooltip = The map and its inverse as rational functions, fitted to the boundary values of the integral equation: numbers, or code that runs as it is

## formula

format = Format
digits = Digits
digits_tooltip = Of half the larger side of the box around the values. GLSL has at most 5: single precision
inverse_of_f = the inverse of f
formula_of_earlier_map = This is the formula of an earlier map: save again for the one that is shown
formula_function = { $name }: degree { $degree }; poles: { $poles }, none inside; largest error: { $error }; digits: { $digits }
formula_reaches = { $name } reaches { $digits } of { $asked } digits
formula_left_out = { $name } is left out: no rational function was found that has one digit
formula_boundary_values = The boundary values of { $name } may be off by { $error }

## words

edited_name = { $name } (edited)
cauchy_green_gpu = Cauchy–Green: GPU
cauchy_green_cpu = Cauchy–Green: CPU
harmonic_coordinates = harmonic coordinates: { $percent } %
cauchy_green_cpu_at = Cauchy–Green: CPU { $percent } %
sizes = m { $boundary } · n { $interior } · prepared in { $duration }
surface_sizes_about = { $count ->
    [one] m: boundary vertices. n: interior vertices. { $shown } triangle.
   *[other] m: boundary vertices. n: interior vertices. { $shown } triangles.
}
edges_flipped = { $count ->
    [one] Intrinsic Delaunay: { $shown } edge flipped, negative weights { $before } → { $after }
   *[other] Intrinsic Delaunay: { $shown } edges flipped, negative weights { $before } → { $after }
}
pending = computing the full map…
pending_tooltip = This map takes longer than a frame. A coarse one is shown while a dot moves, until the full one is there.
size_tooltip = m: boundary samples. n: interior vertices of the mesh.
quality_tooltip = Q is the ratio of the two singular values of the map on a triangle: 1 where angles are kept. Q̄ is its area-weighted mean over the mesh; the largest Q is shown here.
quality_unresolved = not resolved
collapsed_area_tooltip = The share of the area in triangles whose image is a point or a segment up to rounding. They have no Q and are left out of Q̄, which is not resolved where they are more than 1 %.
flipped_tooltip = Triangles whose orientation the map reversed. None for a good map; more boundary samples help where there are some.
frame_tooltip = What the last update of the map took: kernel (harmonic measure: the chance that a random walk from x leaves through a part of the boundary), match (the boundaries' measures are made equal), extend (to the inside), and what drawing took on the processor.
source = source
target = target
stage_sample = sample
stage_assemble = assemble
stage_order = order
stage_table = table
waiting_worker = waiting for the worker…
reading = reading…
sampling_boundary = sampling the boundary…
triangulating = triangulating…
assembling_laplacian = assembling the Laplacian…
ordering = ordering…
factoring = factoring…
solved_iteratively = The Cholesky factor does not fit into memory: solved iteratively. A coarse map follows your drags; the full one takes a while when you let go
mesh_is_coarser = The mesh is coarser than asked for: its refinement stopped at the limit

## lesson

lesson = Lesson
make_lesson = Make a lesson…
make_lesson_tooltip = Pictures with captions, played like the tour; kept in one file or one link
lesson_about = Set up a picture, then add it as a step and write what there is to see. The steps are played like the guided tour.
lesson_title = Title
lesson_caption_hint = What there is to see and to try
add_step = Add step
add_step_tooltip = The present picture becomes the next step
show_step = Show
show_step_tooltip = Shows the picture of this step, to change it
renew_step = Update
renew_step_tooltip = The present picture takes the place of this step's; the caption stays
step_up = Move this step up
step_down = Move this step down
delete_step = Delete this step
title_changed = Title changed
step_added = Step added
step_moved = Step moved
step_deleted = Step deleted
lesson_replaced = The lesson was replaced
lesson_changed_elsewhere = Changed in another tab or window
lesson_kept_own = Also changed in another tab or window; undo shows that version
undo_in_lesson = Undo in the lesson
redo_in_lesson = Redo in the lesson
lesson_is_full = The lesson has as many steps as it can have
lesson_without_steps = The lesson has no step yet
lesson_waits_for_outline = Finish or cancel the editing of the outline first
lesson_waits_for_export = The export is still under way; wait for it or cancel it
lesson_waits_for_shapes = The picture is still being prepared. Try again when it is there
play_lesson = Play lesson
play_lesson_tooltip = Plays the lesson from the first step; Escape ends it
save_lesson = Save…
save_lesson_tooltip = A text file with a link and a caption for each step, which a text editor can change
lesson_link = Copy link
lesson_link_tooltip = One link that plays the whole lesson
open_lesson = Open…
open_lesson_tooltip = Opens a lesson's file to change it
close_lesson = Close the lesson; it is kept
end_lesson_tooltip = Ends the lesson and shows your own picture again
lessons = Lessons
caption_of = Caption of step { $number }
caption_changed = Caption of step { $number } changed
step_renewed = Step { $number } updated
lesson_refused = The lesson cannot be used: { $reason }.
step_refused = This picture cannot be a step: { $reason }.
step_added_but = In the step, { $reasons }.
lesson_not_kept = The lesson is not kept for the next visit: { $reason }

## best map

best_map = Best map
explain_best_map = All conformal maps from one side onto the other differ by three numbers: which point x₁ goes to x₂ (two numbers), and a turn. “Find it” searches all of them for the best: with the most even areas (the least mean of (ln σ₁σ₂)², weighted by area, where σ₁σ₂ is how much a small area grows, up to one common scale), with the least ratio of the largest to the smallest scale (over 98 % of the area, as corners have no scale), with the most even areas in a region that you paint, or with the least deviation from the symmetries of both outlines. First by a formula for the whole family, then on the map itself. The landscape shows the number for every place of x₁, with y₁ and y₂ where they are; “Find it” moves them too, so its number may be lower.
aim_area = Areas
aim_area_tooltip = The most even areas
aim_scale = Scales
aim_scale_tooltip = The least ratio of the largest to the smallest scale, over 98 % of the area
aim_region = Region
aim_region_tooltip = The most even areas in a region of the source that you paint
aim_symmetry = Symmetry
aim_symmetry_tooltip = Keeps the reflections and rotations that both outlines have, and the areas as even as they allow
symmetry_of_outlines = Symmetries are those of two outlines
find_best = Find it
find_best_tooltip = Searches all conformal maps for the best one and moves the points there; one undo step
cancel_best_tooltip = Ends the search; the points stay
course_tooltip = The value of the best map so far, against the number of maps that were tried: gray by a formula, blue of the maps themselves; at the left the value at the beginning, at the right the one that was reached
landscape = Landscape over x₁
landscape_tooltip = Colors every place of x₁ by the value that the map would have with y₁ and y₂ where they are, dark where it is least; click or drag to move x₁ there
landscape_of_surface = The landscape is drawn over an outline; the source is a surface
brush = Paint with the brush
brush_tooltip = A drag over the source paints the region; scroll to zoom, two fingers to move the picture
brush_size = Brush
paint_here = Paint at x₁
paint_here_tooltip = One dab of the brush where x₁ is: for the keyboard, whose arrow keys move x₁
painted_here = x₁ lies in the region already
clear_region = Clear the region
clear_region_tooltip = Removes what was painted
region_in_legend = The part of the source whose areas the search makes even
value_area = Area distortion
value_scale = Ratio of scales
value_region = Area distortion in the region
value_symmetry = Deviation from symmetry
region_is_empty = Paint a region of the source first
best_map_interrupted = The search ended because the points or the shapes have changed
best_sought = The best map is being searched for.
best_area = Area distortion { $before } → { $after } ({ $count } maps tried)
best_scale = Ratio of scales { $before } → { $after } ({ $count } maps tried)
best_region = Area distortion in the region { $before } → { $after } ({ $count } maps tried)
best_symmetry = Deviation from symmetry { $before } → { $after } of the size ({ $count } maps tried)
best_already = No better map was found: { $value } ({ $count } maps tried)
lowest_of_landscape = least: { $value }
accessible_landscape = The landscape over x₁ is lowest at ({ $x }; { $y }), with { $value }.

## tiling
tiling = Tiles
tiling_tooltip = A regular tiling of the hyperbolic plane, carried by the map
tiling_heading = Hyperbolic tiling
explain_tiling = In the hyperbolic plane there is more room than in ours: around a corner you can put tiles that would not fit here, such as three heptagons. The Poincaré disk draws this whole plane in a circle: angles are true, lengths shrink towards the edge. To somebody who lives there all tiles have the same size, and the edge is infinitely far away. A conformal map takes the disk into any shape with the tiling. The middle tile lies at x, one of its edges looks towards y. If you drag x₁, every tile glides on without being bent: to those who live there it is a mere shift, a motion of the hyperbolic plane (a Möbius map of the disk). Where tiles would be too small to be seen they fade into one color.
tile_sides = Sides
tile_sides_tooltip = The number of sides of a tile, p
tiles_at_corner = At a corner
tiles_at_corner_tooltip = The number of tiles around each corner, q. Hyperbolic are the pairs with (p − 2)(q − 2) > 4
tiling_tiles = Colors
tiling_tiles_tooltip = With an even number at a corner, tiles alternate between two colors; with an odd number that is impossible, and a tile's shade says how far it is from the middle one
tiling_edges = Edges
tiling_edges_tooltip = The edges of the tiles alone
tiling_triangles = Mirrors
tiling_triangles_tooltip = Every tile divided by its mirrors: each triangle is the mirror image of its neighbors
tiling_picture = Image
tiling_picture_tooltip = Your own PNG or JPEG in every tile, its lower side towards x
hyperbolic_tiles = Hyperbolic plane
hyperbolic_tiles_about = Heptagons, three to a corner: all of one size to those who live there
tetrahedron = tetrahedron
octahedron = octahedron
cube = cube
icosahedron = icosahedron
dodecahedron = dodecahedron
accessible_tiling = The pattern is the hyperbolic tiling by polygons with { $sides } sides, { $around } around each corner; the middle one lies at the interior point.

## symmetry

symmetry = Symmetry
explain_symmetry = A mirror axis is a line at which an outline is its own mirror image; turned by the listed angle about its center, it lies on itself. Small differences are allowed, and how far an outline is off is listed, as a share of its size (its largest distance from the center of its area). A map is symmetric too where both outlines are and the points lie on their axes. While you drag, x₁ and x₂ are caught by centers and axes, y₁, y₂ and pins by the ends of axes and by corners; hold Alt to move freely.
show_symmetries = Show and snap
show_symmetries_tooltip = Draws the axes and the center of each outline; dragged points snap to them (hold Alt to move freely)
no_symmetry = none
in_center = in the center
in_corner = in a corner
drag_with_alt = Alt while dragging
drag_with_alt_about = Corners, and axes and centers of symmetry, do not catch the dot
symmetries_of = Symmetry of { $side }
symmetry_axis = Axis at { $angle }°, off by { $off } %
symmetry_turns = Turns by { $angle }°, off by { $off } %
symmetry_circle = A circle, off by { $off } %: every line through the center is an axis
more_axes = and { $count } more axes
symmetry_tolerance = Up to { $share } % of the size counts as symmetric.
on_axis = on the axis at { $angle }°
at_axis_end = at an end of the axis at { $angle }°
caught_dot = { $dot } is { $place }.

## chains
continue_from_target = Continue from the target
continue_tooltip = The target becomes the source too, with its shape, points and marks; then choose another target: a chain of maps goes on from there
choose_next_target = Choose a target

## quadrilaterals
quadrilateral = Rectangle and grid
explain_quadrilateral = Four marks make the outline a quadrilateral with curved sides. A conformal map of it onto a rectangle that takes the marks to the corners exists for exactly one ratio of the sides, and is then the only one: three corners determine the map, and the fourth one falls into place for this ratio alone. The ratio is the modulus: how far the side from mark 1 to 2 is from the side from mark 3 to 4, measured by conformal means. The lattice of equal cells of that rectangle, carried back, is a grid in the outline whose lines meet at right angles, as simulations of flow and heat use it.
map_onto_rectangle = Map onto its rectangle
map_onto_rectangle_tooltip = Puts the rectangle of this modulus on the other side and pins three marks to its corners, the fourth one follows; one step to undo
rectangle = Rectangle
orthogonal_grid = Orthogonal grid
orthogonal_grid_tooltip = Lines that meet at right angles, with the marks as corners of the grid
cells_along = cells from mark 1 to 2
cells_across_marks = cells from mark 2 to 3
save_grid = Save grid
pinned_to_corners = Marks 1 to 3 are pinned to their corners; mark 4 misses its own by { $miss }.
grid_accuracy = Nodes right to { $error }, angles to { $angle }°.
grid_error = Nodes right to { $error }.
lines_drawn = One line of { $stride } along { $side } is drawn.
computing_at = Computing… { $percent } %
modulus_uncertain = the modulus is { $value } with an error of { $error }: move the interior point between the marks
explain_mark = A corner of the quadrilateral. Drag it along the outline, or focus it and use the arrow keys; it stays between its neighbors.
mark_of_side = Mark { $mark } of the { $side }
accessible_marks = Marks of the { $side } at { $first }, { $second }, { $third } and { $fourth } % of the boundary.
quadrilateral_limit = For each width by which the quadrilateral is longer, a factor of five in accuracy is lost: at 18 (or 1/18) five digits are left, at 22 two. Move marks so that the quadrilateral gets shorter, or cut the outline across and make the grid of each part.
accessible_grid = Orthogonal grid · { $side }: { $first } × { $second } cells. { $accuracy }
save_grid_as = Save the grid as { $format }

## projections
map_projection = Map projection…
map_projection_tooltip = The map of a country or an island whose scale varies least
projection = Map projection
explain_projection = No flat map of a part of the globe has the same scale everywhere. Among all maps that keep angles, the scale varies least on the one whose scale is the same all along the region's boundary; Chebyshev said so in 1856, Grave proved it, and Milnor gave the proof a new form in 1969. It follows from one boundary value problem: the logarithm of the scale is known on the boundary and is larger there than anywhere inside. The ratio is that of the largest scale to the least one; beside it stands what the best stereographic projection reaches.
projection_begin = Open a GeoJSON file with the outline of a country or an island in longitude and latitude, or look at an island that does not exist.
open_region = Open a region…
open_region_tooltip = A GeoJSON file in longitude and latitude; of several polygons the largest is mapped
show_island = Show an island
show_island_tooltip = An island by formula in the northern Atlantic
island = Island
regions = Regions
scale_ratio = Scale ratio
stereographic_ratio = Stereographic
least_scale = Least scale at
looks_geographic = These coordinates may be longitudes and latitudes.
feature = Feature
all_features = All features
repair_region_tooltip = Cut off small loops where the boundary crosses or touches itself
project_it = Show as a map
project_it_tooltip = Opens the map projection of this file whose scale varies least
scale_lines_legend = Lines of equal scale; on the boundary it is 1.
save_projection = Save
ratio_at_most = { $value } ± { $error }, the least possible
place_in_degrees = longitude { $longitude }°, latitude { $latitude }°
graticule_steps = Meridians every { $longitude }°, parallels every { $latitude }°.
accessible_projection = Map projection of { $name }: scale ratio { $ratio }, stereographic { $stereographic }.
projection_left_out = { $count ->
    [one] The largest region was taken, { $percent } % of the area; one other boundary was left out.
   *[other] The largest region was taken, { $percent } % of the area; { $count } other boundaries were left out.
}
projection_joined = { $count } rings were joined along the antimeridian.
projection_mended = { $count ->
    [one] A point was cut off where the boundary crossed or touched itself.
   *[other] { $count } points were cut off where the boundary crossed or touched itself.
}
projection_holes = { $count ->
    [one] A hole was filled.
   *[other] { $count } holes were filled.
}
projection_overlaps = The map overlaps itself, at the boundary's longitude { $longitude }°, latitude { $latitude }° and elsewhere.
projecting = { $name } is being mapped…
save_projection_as = Save the map as { $format }
