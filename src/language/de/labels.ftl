### What stands on the screen, in German: the words of controls, menus, windows and tooltips.

## bar

smooth_tooltip = Ecken runden: Die Koordinaten breiten sich längs des Umrisses aus wie Wärme; die Fläche bleibt
smooth = Glätten
mirror = Spiegeln
mirror_tooltip = Links und rechts vertauschen, auch bei den beiden Punkten
delete = Löschen
delete_tooltip = Den gewählten Griff entfernen (Entf)
finish_editing = Fertig
handles_tooltip = Ein Quadrat ziehen, um den Umriss umzuformen. Ein Doppelklick auf den Umriss setzt noch eines; ein Rechtsklick oder langes Drücken entfernt eines. Pfeiltasten bewegen das gewählte (fein mit Umschalt), N geht zum nächsten; Escape beendet.
draw_around_shape_go = Die Form in einem Zug umfahren
click_corners = Die Ecken nacheinander setzen
click_points_along_curve = Punkte längs der Kurve setzen
back = Zurück
back_tooltip = Den letzten Punkt zurücknehmen (Rücktaste)
close = Schließen
close_tooltip = Den letzten Punkt mit dem ersten verbinden (Eingabe, oder den ersten Punkt anklicken)
cancel = Abbrechen
cancel_tooltip = Nichts zeichnen (Escape)

## bench

paper_machine = MacBook Air, Apple M3 (8 Kerne), 24 GB; C++, SC Toolbox in MATLAB

## chart

arc_length_y_length = Bogenlänge ab y / Länge
psi_length = ψ · Länge
exact = exakt
this_map = diese Abbildung
arc_length_of_side = Bogenlänge ab y / Länge, { $side }

## colouring

area_distortion = Flächenverzerrung log₂(σ₁σ₂)
angle_distortion = Winkelverzerrung Q = σ₁/σ₂

## convergence

boundary_samples_m = Randpunkte m
error = Fehler
fitted_order = Ordnung { $order }
of_paper = { $column } (Artikel)
max = Maximum
mean = Mittel
convergence_about = Abstand der Randbilder von den exakten, V-Form → Klecks; der Klecks ist etwa 2 breit.

## accuracy

ladder_about = Größte Fehler auf dem Rand, hier gemessen, in einem Thread: des harmonischen Maßes (durchgezogen) und der Bilder (gestrichelt: des Randes der Kreisscheibe, auf ihr, oder vom V auf dem Klecks).
ladder_at_corners = Fehler an den sechs Ecken, wo genaue Werte bekannt sind.
ladder_against_finer = Verglichen mit dem Randintegral mit etwa doppelt so vielen Unbekannten: eine geschlossene Form ist nicht bekannt.
unknowns = Unbekannte
unknowns_tooltip = Unbekannte des linearen Gleichungssystems; bei Zipper seine Punkte
boundary_points = Randpunkte
boundary_points_tooltip = Punkte auf dem Rand: Abtastpunkte oder Knoten der Integralgleichung
milliseconds = Millisekunden
milliseconds_tooltip = Die Zeit für einen Umriss und einen inneren Punkt
boundary_images = Bilder
ladder_outline = Gemessener Umriss
boundary_integral = Randintegral
finite_elements_uniform = Finite Elemente, gleichmäßig
finite_elements_graded = Finite Elemente, voreingestellt
ellipse_4_1 = Ellipse 4:1
rounded_square = Abgerundetes Quadrat
rectangle_10_1 = Rechteck 10×1
notch_1 = Kerbe von 1°
clef_200 = Schlüssel mit 200 Ecken
coast_192 = Küste mit 192 Ecken
accuracy_of_methods = Genauigkeit der Verfahren
accuracy_and_convergence = Genauigkeit und Konvergenz

## invariants

invariants_of = Invarianten · { $side }
compute_invariants = Berechnen
invariants_explained = Zahlen der Form, jede mit einer Schätzung ihres Fehlers, aus einer Integralgleichung auf dem Rand. Keine konforme Abbildung ändert harmonisches Maß, Modul und hyperbolischen Abstand; konformer Radius und Kapazität wachsen mit der Form. Harmonisches Maß: die Wahrscheinlichkeit, dass ein zufälliger Weg vom inneren Punkt den Rand dort zuerst trifft. Konformer Radius: der Betrag der Ableitung der Abbildung der Kreisscheibe auf die Form, 0 auf den inneren Punkt. Kapazität: der Radius der Scheibe, deren Äußeres gleich aussieht. Modul: der extremale Abstand zwischen den Bögen von Marke 1 bis 2 und von Marke 3 bis 4. Hyperbolischer Abstand: zwischen dem inneren und dem zweiten Punkt, für die Krümmung −1.
four_marks = Vier Marken
four_marks_tooltip = Randpunkte als Anteile der Randlänge vom ersten Punkt an, gegen den Uhrzeigersinn: die Maße der Bögen zwischen ihnen und der Modul
mark = Marke { $number }
second_point = Zweiter Punkt
second_point_tooltip = Für den hyperbolischen Abstand
computing = wird berechnet…
conformal_radius = Konformer Radius
capacity = Kapazität
modulus = Modul
hyperbolic_distance = Hyperbolischer Abstand
measure_of_arc = Maß, Bogen { $number }
more_arcs = und { $count } weitere
marks_not_in_order = die Marken müssen vier verschiedene Punkte gegen den Uhrzeigersinn sein
outline_without_curve = der Umriss ist keine Kurve: eine Spitze ist zu schmal

## crowding

riemap_harmonic_measure = riemap (harmonisches Maß)
zipper_run_x1_x2 = Zipper, für x₁, x₂ ausgeführt
zipper_once_then_mobius = Zipper einmal, dann Möbius

## figures

poisson_kernel_harmonic_measure_disk = Poisson-Kern und harmonisches Maß auf der Scheibe
mobius_map_disk_exact_approximate = Eine Möbiustransformation der Scheibe, exakt und genähert
four_ways_map_hand_blob = Vier Wege, eine Hand auf den Klecks abzubilden
angle_distortion_maple_leaf_cinquefoil = Winkelverzerrung vom Ahornblatt zum Fünfblatt
gingerbread_man_conformally_reshaped = Der Lebkuchenmann, konform umgeformt
v_shape_blob_directly_through = Von der V-Form zum Klecks: direkt und über die Scheibe
hemisphere_over_l_shaped_domains = Die Halbkugel über L-förmigen Gebieten
convergence_v_shape = Konvergenz auf der V-Form
angle_distortion_head_over_disk = Winkelverzerrung eines Kopfes über der Scheibe
face_over_planar_domains = Ein Gesicht über ebenen Gebieten

## figures menu

tables_tooltip = Tabellen 1 und 2 · Zeiten auf diesem Rechner neben denen des Artikels
takes_a_minute = Dauert ein bis zwei Minuten, im Hintergrund
as_needed = nach Bedarf
figure_title = Figur { $number } · { $title }
figure_samples_of_outline = { $samples } Punkte auf dem Umriss
figure_boundary_of_surface = { $boundary } Randecken der Fläche
figure_surface_file = die Fläche { $surface }
figure_sides = { $source }, { $target }
figure_samples = { $source } Punkte auf dem Urbild, { $target } auf dem Bild

## file menu

file = Datei
link_tooltip = Die Adresse enthält alles, was eingestellt ist: In einem anderen Browser öffnet sie dasselbe Bild
undo = Rückgängig
undo_tooltip = Den letzten Schritt zurücknehmen; ein Zug ist ein Schritt
redo = Wiederholen
redo_tooltip = Den Schritt noch einmal tun
recent_sessions = Zuletzt
recent_tooltip = Die Sitzung, wie sie verlassen wurde, mit Schritten zum Rückgängigmachen, Flächen und Bild
new_session = Neu
new_session_tooltip = Wieder mit dem ersten Bild beginnen; lässt sich rückgängig machen
open = Öffnen…
open_session_tooltip = Eine Sitzung aus einer .riemap-Datei
save_session = Sichern…
save_session_tooltip = Die Sitzung als .riemap-Datei
copy_link = Link kopieren
full_screen = Ganzer Bildschirm
presentation_size = Vortragsgröße
desk_size = Tischgröße
open_export = Exportieren…
export_tooltip = Bilder, Animationen, Vektorgrafik, Tabellen, Netze

## files

images = Bilder
sessions = Sitzungen
outlines_and_surfaces = Umrisse und Flächen

## gallery

saddle = Sattel
crowding = Crowding
gingerbread_heart = Lebkuchenherz
gingerbread_heart_about = Jedes Glied findet seinen Platz
square_circle = Die Rundung des Quadrats
square_circle_about = Vier Ecken, geglättet
polar_star = Polarstern
polar_star_about = Kreise der Greenschen Funktion, Strahlen gleicher Wahrscheinlichkeit
around_corner = Um die Ecke
around_corner_about = Eine einspringende Ecke: die Singularität aus dem Lehrbuch
leaf_flower = Vom Blatt zur Blüte
leaf_flower_about = Scharfe Spitzen in scharfe Kerben
hand_blob = Eine Hand im Klecks
hand_blob_about = Fünf Finger, jeder ein enger Kanal
unwound = Abgewickelt
unwound_about = Ein langer Gang: Fast alles davon ist ein Randpunkt der Scheibe
gallery_crowding_about = Was der Weg über die Scheibe verliert und der direkte behält
globe_flattened = Ein Globus, verebnet
globe_flattened_about = Die halbe Kugel über der Scheibe: stereographische Projektion
saddle_about = Negative Krümmung über einem Quadrat
gallery_half_torus = Ein halber Torus
gallery_half_torus_about = Ein gebogenes Rohr, geöffnet
animal_over_heart = Tier über Herz
animal_over_heart_about = Die Textur eines Kopfes, in jedem Umriss

## handles

x1 = x₁
x2 = x₂
y1 = y₁

## header

surface = Fläche
panels = Leisten
fit = Einpassen
fit_tooltip = Alles zeigen (Doppelklick)
shapes = Formen
swap = Tauschen
swap_tooltip = Urbild und Bild vertauschen
panels_tooltip = Leisten wegklappen oder zurückholen (Tab)
open_shape_tooltip = Ein Umriss aus einer Datei (JSON, GeoJSON, SVG, CSV, Text) oder eine Fläche (OBJ, PLY, STL, OFF, glTF, GLB)
interior_point_x1 = innerer Punkt x₁
boundary_point_y1 = Randpunkt y₁
x2_f_x1 = x₂ = f(x₁)
y2_f_y1 = y₂ = f(y₁)
edit = Bearbeiten
edit_tooltip = Den Umriss an seinen Griffen umformen (E)

## help menu

help = Hilfe
language = Sprache
theme = Farbschema
system = System
light = Hell
dark = Dunkel
system_tooltip = Hell oder dunkel, wie das System
light_tooltip = Dunkle Schrift auf hellem Grund
dark_tooltip = Helle Schrift auf dunklem Grund
open_gallery = Galerie…
open_gallery_tooltip = Sehenswerte Abbildungen
guided_tour = Rundgang
guided_tour_tooltip = Sechs Bilder: was eine konforme Abbildung ist, und was sie festhält
open_keys_and_gestures = Tasten und Gesten…
open_keys_and_gestures_tooltip = Was Tasten, Maus und Finger tun
system_language_tooltip = Die Sprache des Systems, falls es eine von diesen ist
open_paper_figures = Figuren des Artikels…
open_paper_figures_tooltip = Seine Figuren und Tabellen, neu berechnet

## layout

plots = Kurven
controls = Einstellungen

## legend

mean_of = Mittel { $value }

## locks

locked = Die Adresse der Seite hält dies fest

## method

cauchy_green_needs_plane = Das Cauchy-Integral läuft über einen Rand in der Ebene; der einer Fläche liegt im Raum
exact_needs_integral = Genaue Bilder brauchen den Integral-Kern auf beiden Seiten: Finite Elemente kennen den Rand nur auf zwei bis drei Stellen
harmonic_for_now = vorerst harmonisch · { $percent } %
harmonic = Harmonisch
cauchy_green = Cauchy–Green
exact_images = Genau
integral_kernel = Integral
adjoint_kernel = Adjungiert
table_paper = Tabelle (Artikel)
cholesky = Cholesky
pcg = PCG
harmonic_tooltip = Das Innere folgt dem Rand nach der diskreten Laplace-Gleichung: überdeckt das andere Gebiet genau
cauchy_green_tooltip = Das Innere folgt nach dem Cauchy-Integral des Randes: glatt, doch der Rand kann schrumpfen oder sich wölben
exact_images_tooltip = Die Bilder des Netzes nach dem Cauchy-Integral über die Randkurven, auf so viele Stellen wie der Rand; harmonisch, solange sich etwas bewegt
integral_kernel_tooltip = Das harmonische Maß aus einer Integralgleichung auf der Randkurve: zehn Stellen und mehr. Bis ihre Matrix zerlegt ist, werden finite Elemente gezeigt
adjoint_kernel_tooltip = Das harmonische Maß mit finiten Elementen, zwei bis drei Stellen: eine Lösung des transponierten Systems für jeden neuen inneren Punkt
finite_elements = finite Elemente
finite_elements_tooltip = Den Integralkern gibt es hier nicht:
surfaces_use_finite_elements = Eine Fläche hat keine Randkurve in der Ebene: Ihre Seite wird mit finiten Elementen berechnet
sharpening = wird geschärft…
sharpening_tooltip = Die Abbildung mit finiten Elementen wird gezeigt, während die Integralgleichung des Randes zerlegt wird
refining = wird verfeinert…
refining_tooltip = Das Netz wird verfeinert, wo Bilder lang sind; solange wird die gröbere Abbildung gezeigt
unresolved_tooltip = Schraffierte Teile des Umrisses, als Anteil seiner Fläche: Sie gehören zu weniger als einem Millionstel der Größe des anderen Gebiets
error_estimate_tooltip = Eine Schätzung des größten Fehlers eines Bildes auf dem Rand, in den Einheiten seines Umrisses. Sie berücksichtigt die Kondition an Ecken und folgt aus Identitäten, für die man die genaue Abbildung nicht braucht. Das harmonische Maß selbst:
unknowns_of = { $side }: Integral, { $count } Unbekannte
kernel_of = { $side }: { $kernel }
table_paper_tooltip = Die harmonischen Koordinaten jeder Ecke, wie im Artikel im Voraus berechnet: dieselben Zahlen wie mit dem adjungierten Kern
cholesky_tooltip = Ein vollständiger dünnbesetzter Cholesky-Faktor: schnell und genau, selbst wo das Maß 1e-300 ist
pcg_tooltip = Konjugierte Gradienten mit einem unvollständigen Faktor: wenig Speicher, 15- bis 300-mal langsamer; beim Ziehen springt eine grobe Abbildung ein

## interpretation

outline_of = Umriss · { $side }
interpret_auto = Automatisch
interpret_polygon = Vieleck
interpret_smooth = Glatt
interpret_auto_tooltip = Die Kurve der Datei, falls es eine gibt, sonst eine glatte Kurve durch 64 Punkte oder mehr, wenn nicht viele davon Ecken sind
interpret_polygon_tooltip = Gerade Kanten zwischen den Punkten
interpret_smooth_tooltip = Die Kurve der Datei oder eine glatte Kurve durch die Punkte, so wenige es sind, mit Ecken, wo sie scharf abbiegen
taken_for = aufgefasst als { $kind }, { $corners ->
    [one] { $corners } Ecke
   *[other] { $corners } Ecken
}
taken_polygon = Vieleck
taken_smooth = glatt
corners_of = Ecken ({ $count })
corner_at = Ecke { $number } bei ({ $x }; { $y })
corner_tooltip = Mit Haken biegt der Umriss hier ab, ohne Haken geht er glatt hindurch
corner_mark_tooltip = Eine Ecke: klicken, um sie zu glätten
smooth_mark_tooltip = Glatt: klicken, um eine Ecke daraus zu machen

## names

disk = Scheibe
square = Quadrat
gingerbread_man = Lebkuchenmann
heart = Herz
blob = Klecks
v_shape = V-Form
cinquefoil = Fünfblatt
maple_leaf = Ahornblatt
hand = Hand
turkey = Truthahn
l_shape = L-Form
star = Stern
spiral = Spirale
hemisphere = Halbkugel
paraboloid = Paraboloid
bent_strip = Gebogener Streifen
half_torus = Halber Torus
face_like = Gesichtsartig
animal_head = Tierkopf
drawn = Zeichnung
traced = Nachgezeichnet
pasted = Eingefügt

## keyboard navigation

picture_source = Ansicht des Urbilds
picture_target = Ansicht des Bildes
x1_interior_point_source = x₁, innerer Punkt des Urbilds
x2_interior_point_target = x₂, innerer Punkt des Bildes
y1_boundary_point_source = y₁, Randpunkt des Urbilds
y2_boundary_point_target = y₂, Randpunkt des Bildes
probe = Kreis mit Kreuz, im Urbild

## offer

trace_picture_tooltip = Der Umriss der größten Form in einem PNG oder JPEG
picture_texture = Das Foto ist das Muster.
trace_outline = Als Umriss nachzeichnen
picture_opened = „{ $name }“ ist ein Foto oder eine Grafik.
trace_silhouette = Silhouette nachzeichnen
use_picture = Als Muster verwenden
use_picture_tooltip = Beide Umrisse behalten und das Bild über den legen, dessen Muster abgebildet wird
choose_part = Anderen wählen
parts_of = In „{ $file }“:
part_number = Nr. { $number }
file_has_parts = Die Datei hat { $count } Teile; einer davon wird gezeigt.
no = Nein

## other

english = English
deutsch = Deutsch

## overlay

through_disk_fresh = über die Scheibe, frisch
through_disk_precomputed = über die Scheibe, vorberechnet
random_walks = Irrfahrten
disk_fresh = Scheibe, frisch
disk_precomputed = Scheibe, vorberechnet
hits = Treffer

## page

graphics_lost = Der Browser hat dieser Seite die Grafik entzogen, wie nach einem Absturz des Grafiktreibers oder nach dem Ruhezustand. Die Abbildung bleibt erhalten: Seite neu laden, um fortzufahren.
no_graphics = riemap zeichnet mit WebGPU oder WebGL 2, und dieser Browser bietet hier keines von beiden. Ein aktueller Firefox, Chrome, Edge oder Safari mit eingeschalteter Hardwarebeschleunigung genügt.
stopped = riemap ist wegen eines eigenen Fehlers stehen geblieben. Seite neu laden, um fortzufahren. ({ $reason })

## paint

sixty_equal_steps = 60 gleiche Schritte von ω
their_images = deren Bilder

## panel

vertices = Ecken
intrinsic_delaunay = Intrinsische Delaunay-Kanten
back_plane = Zurück in die Ebene
back_plane_tooltip = Wieder den Umriss dieser Seite zeigen
boundary_loops = Randkurven
explain_boundary_loops = Diese Fläche hat mehrere Randkurven. Die hier oder mit einem Klick im Bild gewählte wird auf den Umriss abgebildet. Die anderen werden gefüllt, und die Abbildung ist die der gefüllten Fläche.
choose_loop = Diese Randkurve zum Umriss machen
faults_in_red = { $unmarked ->
    [0] Was sich nicht öffnen ließ, mit den Fehlern in Rot ({ $marked }): Ziehen dreht es
   *[other] Was sich nicht öffnen ließ, mit { $marked } der Fehler in Rot ({ $unmarked } weitere sind nicht markiert): Ziehen dreht es
}
loop_in_list = { $number }: Länge { $length }, { $vertices } Ecken
loop_in_picture = Randkurve { $number } von { $count }: Klick macht sie zum Umriss
holes = Löcher
holes_filled = Gefüllt
holes_filled_tooltip = Die Füllung der anderen Randkurven mitzeichnen: mit dem Muster, und grau in den Farben der Verzerrung. Gesicherte Flächen behalten ihre Löcher
holes_open = Offen
holes_open_tooltip = Die anderen Randkurven offen lassen: Ihre Füllung gibt es nur in der Abbildung, nicht im Bild. Gesicherte Flächen behalten ihre Löcher
along_boundary = { $count } entlang des Randes
surface_map_tooltip = Der Laplace-Operator einer Fläche folgt aus den Längen ihrer Kanten; das harmonische Maß auf ihrem Rand wird mit dem der anderen Seite abgeglichen. Über einem Umriss erhält jede Ecke ihren Ort darin: ihre Texturkoordinate; auf einer anderen Fläche einen Punkt von dieser
delaunay_tooltip = Kanten werden innerhalb der Fläche umgeklappt, bis alle Kotangensgewichte positiv sind: Dann ist es auch das harmonische Maß, und der Rand behält seine Reihenfolge. Die Fläche selbst bleibt, wie sie ist
surface_direction = Jeder Punkt der Fläche wird auf den Umriss des Urbilds abgebildet
surface_direction_target = Jeder Punkt der Fläche wird auf den Umriss des Bildes abgebildet
surfaces_direction = Beide Flächen werden auf die Einheitskreisscheibe abgebildet; Punkte am selben Ort der Scheibe entsprechen einander
through_disk = Über die Scheibe
random_walks_heading = Irrfahrten
this_map_had_none = (diese Abbildung: keine)
under_a_hundredth_percent = unter 0.01 %
clear = Leeren
clear_tooltip = Alle Treffer vergessen
start = Start
pause = Pause
rays = { $count } Strahlen
cells_across = { $count } Zellen quer
points_collapsed = { $collapsed } von { $samples } Punkten zusammengefallen
this_map_had = (diese Abbildung: { $count })
out_order = { $count } in falscher Reihenfolge
all_points_kept_apart = alle { $count } Punkte getrennt geblieben
largest_difference = größter Unterschied { $share } der Länge
walks = { $count ->
    [one] { $shown } Irrfahrt
   *[other] { $shown } Irrfahrten
}
largest_deviation = größte Abweichung von ω: { $deviation } (Zufall: etwa { $chance })
conformal = Konform
euclidean = Euklidisch
in_source = Im Urbild
in_target = Im Bild
off = Aus
fresh = Frisch
precomputed = Vorberechnet
conformal_tooltip = Das Polargitter der Scheibe auf beiden Seiten: Die Kreise sind Niveaulinien der Greenschen Funktion um x, zwischen den Strahlen liegt gleiches harmonisches Maß, der erste endet in y. Für eine konforme Abbildung sind alle Zellen Quadrate
euclidean_tooltip = Echte Kreise und Strahlen um den inneren Punkt der Seite, auf der das Muster liegt
in_source_tooltip = Das Muster liegt auf dem Urbild und wird zum Bild vorgeschoben; passt am besten zu „Rückwärts“, das das ganze Bild füllt
in_target_tooltip = Das Muster liegt auf dem Bild und wird zum Urbild zurückgezogen; passt am besten zu „Vorwärts“, das das ganze Urbild füllt
off_tooltip = Diese Abbildung allein
fresh_tooltip = Beide Gebiete werden für jede Lage von x₁ und x₂ neu auf die Scheibe abgebildet, mit dem geodätischen Algorithmus: richtig, aber zu langsam zum Ziehen; bis die Punkte ruhen, werden wenige Randpunkte benutzt
precomputed_tooltip = Jedes Gebiet wird einmal auf die Scheibe abgebildet, für seine Mitte; x zu bewegen ist dann nur noch eine Möbiustransformation. Schnell, doch in langen Armen gehen der Scheibe die Stellen aus: Punkte fallen zusammen oder tauschen ihre Plätze, und keine Möbiustransformation trennt sie wieder
both_tooltip = Frische und vorberechnete Scheibenabbildungen nebeneinander: Was bei der zweiten verloren geht und bei der ersten nicht, geht durch Crowding verloren
through_disk_tooltip = Warum nicht beide Umrisse auf eine Scheibe abbilden und über sie gehen? Auf dem Umriss, auf den abgebildet wird, sind die Striche nach innen die Bilder von 60 Punkten in gleichen Schritten des harmonischen Maßes unter dieser Abbildung, die nach außen jene über die Scheibe: Wo beide übereinstimmen, wird jedes Paar zu einer Linie. Die blassen Punkte sind die Bilder aller Randpunkte. Ein Punkt ist zusammengefallen, wenn zwischen ihm und dem vorigen keine Stellen bleiben, und in falscher Reihenfolge, wenn er vor diesem landet
walks_tooltip = Kakutani (1944): Das harmonische Maß eines Randstücks ist die Wahrscheinlichkeit, dass eine Irrfahrt ab x₁ durch dieses Stück austritt. Jeder Sprung führt zu einem zufälligen Punkt des größten Kreises, der hineinpasst. Balken: der Anteil der Treffer in jedem Randstück; Querstriche: sein harmonisches Maß

## paste

paste_kinds = SVG-Pfaddaten (M 0 0 L 2 0 …), SVG, Koordinaten (0,0 2,0 1,3 oder ein Punkt je Zeile), JSON oder GeoJSON
paste_outline_source = Einen Umriss für das Urbild einfügen
paste_outline_target = Einen Umriss für das Bild einfügen
use_pasted = Verwenden

## pins

which_map = Welche Abbildung
explain_which_map = Eine konforme Abbildung hat drei Freiheitsgrade. Ein Punkt x₁ mit seinem Bild x₂ und ein Randpunkt y₁ mit y₂ verbrauchen sie, ebenso drei Randpaare („Pins“) in gleicher Reihenfolge auf beiden Seiten: jeder Pin des Urbilds kommt genau auf den Pin mit seiner Nummer. Mehr als drei Pins verfehlt die Abbildung so wenig wie möglich (kleinste Quadrate); bei jedem steht, um wie viel.
by_points = Punkte
by_points_tooltip = x₁ kommt nach x₂ und y₁ nach y₂
by_pins = Pins
by_pins_tooltip = Drei oder mehr Randpunkte kommen auf ebenso viele Randpunkte; x₁ und x₂ folgen
add_pin = Pin hinzufügen
add_pin_tooltip = Fügt einen Pin mit seinem jetzigen Bild hinzu, wie ein Doppelklick auf einen Umriss. Entf entfernt den ausgewählten
no_more_pins = Es sind 64 Pins, oder die Bilder weiterer lassen sich nicht unterscheiden
pins_do_not_play = Pins halten die Abbildung fest: Unter „Welche Abbildung“ „Punkte“ wählen, damit sich Punkte bewegen
pin_misses_tooltip = Der Abstand zwischen dem Bild des Pins und dem Pin des Bilds, in dessen Einheiten
pins_in_legend = Pins: jeder kommt auf den seiner Nummer
explain_pin = Ein Randpunkt, der auf den Pin mit derselben Nummer auf der anderen Seite kommt. Zieh ihn am Umriss entlang; ein Doppelklick auf den Umriss fügt einen hinzu.
pin_misses_by = verfehlt um { $miss }
remove_pin = Pin { $pin } entfernen
pin_of_side = Pin { $pin } ({ $side })
accessible_pin = Pin { $pin } von { $source } % nach { $target } % der Ränder, verfehlt um { $miss }.

## play panel

speed = Tempo
all = Alle
x1_tooltip = Der innere Punkt des Urbilds läuft auf einem Kreis, der innen bleibt
x2_tooltip = Der innere Punkt des Bildes läuft auf einem Kreis, der innen bleibt
y1_tooltip = Der Randpunkt des Urbilds läuft einmal um; gleiche Zeiten sind gleiche harmonische Maße: die Kreisscheibe dreht sich gleichmäßig
all_tooltip = Alle zugleich, durch alle Abbildungen des einen Gebiets auf das andere
no_plane = Dieser Punkt liegt auf einer Fläche: er wird von Hand gezogen
play_tooltip = Die Punkte auf einer Schleife laufen lassen oder anhalten, wo sie sind (Leertaste)
seconds_for_turn = { $seconds } s je Umlauf
stop_here = Hier anhalten
play = Abspielen

## plots

log = log
poisson_kernel = Poisson-Kern
reparameterisation = Umparametrisierung
kernel = Kern
measure = Maß
reparam = Umparam.
poisson_kernel_tooltip = ψ·ℓ: wie wahrscheinlich eine Irrfahrt ab x durch ein Stück des Randes austritt, bezogen auf dessen Anteil an der Länge; 1, wo es so wahrscheinlich ist wie im Mittel
harmonic_measure_tooltip = ω: die Wahrscheinlichkeit, dass eine Irrfahrt ab x durch den Rand zwischen y und hier austritt, gegen den Uhrzeigersinn. Die Abbildung führt jeden Punkt in den mit demselben Maß über
reparameterisation_tooltip = r: wohin die Abbildung einen Randpunkt führt, in Bogenlänge ab y; gerade, wo Längenverhältnisse erhalten bleiben
log_tooltip = Logarithmische Achse: zeigt, wie tief der Kern fällt, wo es im Gebiet eng wird

## presentation

full_screen_tooltip = Den ganzen Bildschirm füllen oder wieder ein Fenster sein (F)
presentation_tooltip = Schrift, Regler, Punkte und Linien um die Hälfte größer, um von Weitem lesbar zu sein

## reports

done = fertig
too_large = zu groß
measuring_rows = { $count ->
    [one] es wird gemessen, noch { $count } Zeile…
   *[other] es wird gemessen, noch { $count } Zeilen…
}
paper_machine_and_here = Artikel: { $machine }. Hier: ein Thread.
tables_of_paper = Tabellen 1 und 2 auf diesem Rechner
convergence_of_paper = Figur 15: Konvergenz auf der V-Form, bis m = 2000
setting_paper = Einstellungen des Artikels: gleichmäßige Punkte und Dreiecke
setting_default = Voreinstellungen von riemap: adaptive Punkte, abgestufte Dreiecke
table_1 = Tabelle 1: Vorbereitung, in Sekunden
table_2 = Tabelle 2: ein Bild, in Millisekunden
factor = faktorisieren
with_psi = mit Ψ
zipper = Zipper
bff_paper = BFF, Artikel
psi_match_x1_moves = ψ + Abgleich, x₁ bewegt
x2_moves = ψ + Abgleich, x₂ bewegt
extend = Fortsetzung
stage_mesh = vernetzen

## sessions

link_copied = Link kopiert

## settings

show = Zeigen
unit_box = Einheitsbox
true_scale = Wahre Größe
unit_box_tooltip = Texturkoordinaten werden in die Einheitsbox verschoben und skaliert
true_scale_tooltip = Texturkoordinaten sind die des Umrisses
per_second = { $rate } je Sekunde
both = Beide
source_heading = Urbild
target_heading = Bild
ground = Grund
transparent = Durchsichtig
transparent_tooltip = Ohne die Farbe hinter der Abbildung
corners = Ecken
hit_corners = Genau treffen
hit_corners_tooltip = Die Randkanten der Fläche werden dort geteilt, wo die Ecken des Umrisses liegen, damit keine Ecke leer bleibt. Neue Eckpunkte stehen hinter denen der Datei.
dots = Punkte
both_points = Innerer Punkt und Randpunkt
both_points_tooltip = Die Punkte x und y auf beiden Seiten
coordinates = Koordinaten
size = Größe
width_pixels = Breite in Pixeln
height_pixels = Höhe in Pixeln
motion = Bewegung
duration = Dauer
duration_tooltip = Dauer eines Umlaufs in Sekunden
pictures = Bilder
pictures_tooltip = Anzahl der Bilder eines Umlaufs

## shapes

open_file = Datei öffnen…
draw_freehand = Freihand zeichnen
draw_freehand_tooltip = Die Form in einem Strich umfahren; Ecken bleiben Ecken (D)
draw_lines = Strecken zeichnen
draw_lines_tooltip = Gerade Kanten zwischen angeklickten Punkten (L)
draw_curve = Kurve zeichnen
draw_curve_tooltip = Eine glatte Kurve durch angeklickte Punkte (C)
paste = Einfügen…
paste_tooltip = SVG-Pfaddaten oder Koordinaten; Strg+V gilt überall dem Urbild
trace_picture = Foto nachzeichnen…

## shortcuts

mouse_fingers = Maus und Finger
drag_dot_gesture = Einen Punkt ziehen
drag_dot_gesture_about = Bewegt, was die Abbildung festhält; sie folgt
drag_beside_dots = Neben den Punkten ziehen
drag_beside_dots_about = Bewegt das Bild; eine Fläche wird gedreht, mit Umschalt verschoben
wheel_two_fingers = Rad oder zwei Finger
wheel_two_fingers_about = Vergrößert; zwei Finger verschieben auch
double_click = Doppelklick
double_click_about = Zeigt wieder alles; bei Pins auf einem Umriss: setzt einen mit seinem Bild
drop_file = Eine Datei ablegen
drop_file_about = Öffnet einen Umriss, eine Fläche, ein Bild oder eine Sitzung
keys = Tasten
key_tab = Tab
key_tab_about = Klappt die Leisten weg oder holt sie zurück
key_p = P
key_p_about = Öffnet und schließt die Kurven
key_f = F
key_f_about = Füllt den Bildschirm oder gibt ihn frei
ctrl_z = Strg+Z
ctrl_z_about = Nimmt einen Schritt zurück
ctrl_shift_z_ctrl_y = Strg+Umschalt+Z oder Strg+Y
ctrl_shift_z_ctrl_y_about = Tut ihn noch einmal
ctrl_s = Strg+S
ctrl_s_about = Sichert die Sitzung als Datei
without_mouse = Ohne Maus
f6_shift_tab = F6 oder Umschalt+Tab
arrow_keys_dot = Pfeiltasten auf einem Punkt
arrow_keys_dot_about = Bewegen ihn, mit Umschalt fein. Ein Randpunkt läuft den Rand entlang; Entf entfernt einen Pin
arrow_keys_picture = Pfeiltasten auf einem Bild
arrow_keys_picture_about = Bewegen es oder drehen die Fläche; + und − vergrößern, 0 zeigt alles
space_enter = Leertaste oder Eingabe
space_enter_about = Drückt eine Schaltfläche
f6_shift_tab_about = Beginnt durch Bedienelemente, Bilder und Punkte zu gehen; Tab geht weiter, Esc beendet
space = Leertaste
space_about = Setzt die Punkte in Bewegung, oder hält sie an, wo sie sind
ctrl_e = Strg+E
ctrl_e_about = Öffnet das Fenster, das Bilder, Animationen und andere Dateien sichert
drawing_reshaping = Zeichnen und Umformen
d_l_c = D, L, C
d_l_c_about = Zeichnet einen Umriss: freihändig, mit geraden Kanten, als Kurve; für die Seite unter dem Zeiger
enter_backspace = Eingabe, Rücktaste
enter_backspace_about = Schließt das Gezeichnete; nimmt seinen letzten Punkt zurück
key_e = E
key_e_about = Formt den Umriss unter dem Zeiger an seinen Griffen um oder beendet das
double_click_outline = Doppelklick auf den Umriss
double_click_outline_about = Setzt einen weiteren Griff; ein Rechtsklick oder langes Drücken entfernt einen
n_shift_n = N, Umschalt+N
n_shift_n_about = Zum nächsten Griff, zum vorigen
arrow_keys_delete = Pfeiltasten, Entf
arrow_keys_delete_about = Bewegen den gewählten Griff, mit Umschalt fein; entfernen ihn
escape = Escape
escape_about = Beendet Zeichnen, Umformen und den Rundgang und schließt Fenster
ctrl_v = Strg+V
ctrl_v_about = Nimmt einen Umriss aus der Zwischenablage: Pfaddaten, Koordinaten, GeoJSON

## side panel

map = Abbildung
mesh = Netz
mesh_tooltip = Die Kanten des abgebildeten Netzes und seines Bildes auf der anderen Seite
uv_layout = Layout
uv_grid = UV-Gitter
explain_uv = Die Texturkoordinaten u und v der gesicherten Fläche, über dem Umriss: das Einheitsquadrat mit seinen Achsen, und die Ränder von Löchern als Nähte. Mit Netz das Layout der Dreiecke. Das Exportfenster wählt zwischen Einheitsquadrat und wahrem Maßstab.
texture = Muster
move_picture = Im Bild verschieben
move_picture_tooltip = Ziehen verschiebt es. Scrollen oder zwei Finger ändern die Größe; Umschalt und Scrollen oder zwei drehende Finger drehen es.
picture_across = Rechts
picture_across_tooltip = Von der Mitte des Umrisses nach rechts, in Teilen seiner größeren Seite
picture_up = Oben
picture_up_tooltip = Von der Mitte des Umrisses nach oben, in Teilen seiner größeren Seite
picture_size = Größe
picture_size_tooltip = Bei 100 % passt das ganze Bild über den Umriss
picture_turn = Drehung
picture_turn_tooltip = Gegen den Uhrzeigersinn, in Grad
whole_picture = Ganzes Bild zeigen
whole_picture_tooltip = Aufrecht, in der Mitte des Umrisses
choose = Wählen…
scale = Maßstab
samples = Randpunkte
keep_corners = Ecken behalten
keep_corners_tooltip = Auch die Ecken des Umrisses sind Randpunkte
as_many_as_needed = So viele, wie der Umriss braucht
adaptive_samples_tooltip = Abstände allein nach Krümmung, Ecken und Breite der Engstellen
growth = Wachstum
resolution_of = Auflösung · { $side }
automatic = { $value }, automatisch
per_distance = { $growth } je Abstand
forward = Vorwärts
backward = Rückwärts
angle = Winkel
area = Flächen
checker = Karos
grid = Gitter
polar = Polar
image = Foto
adaptive = Adaptiv
uniform_paper = Gleichmäßig
graded = Abgestuft
uniform_mesh = Gleichmäßig
forward_tooltip = Das Netz des Urbilds wird in das Bild abgebildet
backward_tooltip = Das Netz des Bildes wird in das Urbild abgebildet und liest dort sein Muster
texture_tooltip = Das Muster, das die Abbildung überträgt
angle_tooltip = Winkelverzerrung Q = σ₁/σ₂ jedes Dreiecks: 1, wo Winkel erhalten bleiben
area_tooltip = Flächenverzerrung log₂(σ₁σ₂) jedes Dreiecks, vom Urbild zum Bild: +1 ist die doppelte Fläche, −1 die halbe. Die Farben gehen vom Mittel aus
checker_tooltip = Quadrate; Winkel von 90° bleiben Winkel von 90°
lines = Linien
polar_tooltip = Kreise und Strahlen um den inneren Punkt
image_tooltip = Ein eigenes PNG oder JPEG; irgendwo ablegen genügt
adaptive_tooltip = Dichter an Ecken, bei starker Krümmung und in Engstellen: ein kleinerer Fehler bei gleicher Zahl
uniform_paper_tooltip = Gleiche Abstände in der Bogenlänge, wie im Artikel
graded_tooltip = Dreiecke wachsen mit dem Abstand vom Rand: 4–15 % der Ecken bei fast gleichem Fehler
uniform_mesh_tooltip = Dreiecke von einer Größe, wie im Artikel

## accessibility

accessible_quality = { $count ->
    [one] Mittlere Winkelverzerrung { $mean }; { $count } Dreieck umgeklappt.
   *[other] Mittlere Winkelverzerrung { $mean }; { $count } Dreiecke umgeklappt.
}
accessible_collapsed = { $share } Prozent der Fläche sind Dreiecke ohne aufgelöstes Bild.
being_prepared = Wird vorbereitet.
problem = Problem: { $what }
accessible_surface_map = Die Fläche { $surface }, konform abgebildet auf den Umriss { $outline }.
accessible_map_of_surfaces = Konforme Abbildung von der Fläche { $source } auf die Fläche { $target }.
accessible_map = Konforme Abbildung von { $source } nach { $target }.
points_of_side = { $interior } bei ({ $place }), { $boundary } bei { $percent } % des Randes.
accessible_pointed = Unter dem Zeiger: { $point } geht auf { $image }, Maßstab { $scale }, Drehung { $turning } Grad.
button = Schaltfläche
choice = Auswahl
check_box = Kontrollkästchen
slider = Schieberegler
text_field = Textfeld
selected = gewählt
not_selected = nicht gewählt
not_available = nicht verfügbar

## status

fps_tooltip = Solange sich etwas bewegt; in Ruhe wird nichts gezeichnet
pointed = { $point } → { $image } · Maßstab { $scale } · Drehung { $turning }°
by_mesh = Netz
pointed_tooltip = Der Punkt unter dem Zeiger, sein Bild, und wie stark die Abbildung dort vergrößert und dreht: |f′| und arg f′. Alle Stellen stimmen nach der Fehlerschätzung; „Netz“: in einem Dreieck interpoliert, zwei bis drei Stellen
error_estimate = Fehler { $value }
unresolved = unaufgelöst { $share }
largest_q = größtes Q: { $value }
flipped = umgeklappt { $count }
collapsed_area = zusammengefallen { $share } %
frame_parts = Kern { $kernel } ms + Abgleich { $matching } ms + Fortsetzung { $extension } ms
frame_times = Rechnen { $compute } ms + Zeichnen { $draw } ms
fps = { $rate } Bilder/s
hint_plane = Scrollen zoomt · Dateien überall ablegen
hint_surface = Ziehen dreht die Fläche · Umschalt verschiebt sie · Scrollen zoomt
hint_plane_touch = Zwei Finger zoomen · Tippen zeigt das Bild eines Punktes
hint_surface_touch = Ziehen dreht die Fläche · zwei Finger verschieben und zoomen

## advanced

advanced = Erweitert
advanced_tooltip = Richtung, Verfahren, Vergleiche, Auflösung, Invarianten
pattern = Muster
coloring = Färbung
extension = Fortsetzung
kernel_heading = Kern
solver = Löser
explain_direction = Welche Seite in Dreiecke zerlegt und übertragen wird. Rückwärts: Jeder Punkt des Bildes sucht seinen Platz im Urbild, das hält das Muster scharf. Vorwärts: Die Dreiecke des Urbilds werden ins Bild gelegt.
explain_extension = Zuerst wird die Abbildung auf dem Rand bestimmt. Die Fortsetzung trägt sie ins Innere, auf eine von drei Arten.
explain_kernel = Der Kern sagt, wie viel jedes Stück des Randes von x aus zählt: die Wahrscheinlichkeit, dass ein zufälliger Weg von x dort endet. Das Integral rechnet auf dem Rand selbst, auf viele Stellen genau; die anderen rechnen auf den Dreiecken.
explain_solver = Wie die vielen linearen Gleichungen auf den Dreiecken gelöst werden: auf einmal (Cholesky) oder schrittweise mit wenig Speicher (PCG).
explain_through_disk = Der übliche Weg bildet beide Figuren auf eine runde Scheibe ab und geht über sie. Lange Arme schrumpfen dort zu nichts. Eingeschaltet zeigt sich, was dieser Weg verliert und die direkte Abbildung behält.
explain_walks = Punkte, die von x₁ aus zufällig wandern, bis sie auf den Rand treffen. Wie viele auf einem Stück enden, ist sein harmonisches Maß: Die Wege prüfen die Zahlen, aus denen die Abbildung entsteht.
explain_interpretation = Ob gerade Kanten oder eine glatte Kurve die Punkte des Umrisses verbinden, und welche von ihnen Ecken sind.
explain_resolution = Wie viele Punkte der Rand bekommt, und wie schnell die Dreiecke zur Mitte hin wachsen. Mehr Punkte sind feiner und langsamer.
explain_surface = Wie fein die Fläche geteilt ist. Intrinsische Delaunay-Dreiecke machen ihre Zahlen verlässlich und lassen ihre Form, wie sie ist.
explain_plots = Drei Kurven längs des Randes: wie stark jedes Stück zählt (Poisson-Kern), die laufende Summe davon (harmonisches Maß), und welche Stelle des einen Randes zu welcher des anderen gehört (Umparametrisierung).

## dots

explain_x1 = x₁: ein Punkt im Inneren des Urbilds. Die Abbildung bringt ihn nach x₂. Zieh ihn: Das Bild folgt.
explain_x2 = x₂ = f(x₁): der Punkt im Inneren des Bildes, auf den x₁ abgebildet wird. Zieh ihn, um einen anderen zu wählen.
explain_y1 = y₁: ein Punkt auf dem Rand des Urbilds. Die Abbildung bringt ihn nach y₂. Zieh ihn am Rand entlang: Das Innere dreht sich um x₁.
explain_y2 = y₂ = f(y₁): der Randpunkt des Bildes, auf den y₁ abgebildet wird. Zieh ihn am Rand entlang.

## welcome

welcome = riemap formt eine Figur in eine andere um, und alle Winkel bleiben, wie sie sind.
take_tour = Rundgang
draw_own = Selbst zeichnen
open_own = Datei oder Fläche öffnen
close_welcome = Begrüßung schließen

## top bar

riemap_tooltip = Die konforme Abbildung zwischen zwei Umrissen, durch Abgleich des harmonischen Maßes
column_tooltip = Die Einstellungen wegklappen oder zurückholen (Tab: alles)
share = Teilen
share_link = Teilen…
share_by_system = Teilen…
qr_code = Der Link als QR-Code
scan_code = Eine Kamera darauf richten: Das Handy öffnet diese Abbildung.
plots_tooltip = Poisson-Kern, harmonisches Maß und Umparametrisierung entlang der Ränder (P)

## tour

harmonic_measure = Harmonisches Maß
harmonic_measure_in_legend = harmonisches Maß
of = { $part } von { $whole }
next = Weiter
end = Beenden
keep_picture = Dieses Bild behalten
keep_picture_tooltip = Endet hier, und dieses Bild bleibt
show_again = Noch einmal zeigen
end_tour_tooltip = Beendet den Rundgang und zeigt wieder das eigene Bild
map_between_two_shapes = Eine Abbildung zwischen zwei Formen
map_between_two_shapes_about = Was in einem Umriss gezeichnet ist, wird in den anderen übertragen: von Ort zu Ort gestreckt und gedreht, aber nie zerrissen und nie gefaltet. x₁ wandert einmal herum, und alles folgt. Danach einen grünen Punkt ziehen.
angles_stay = Winkel bleiben
angles_stay_about = Das heißt konform. Der kleine Kreis wird wieder ein Kreis, größer oder kleiner (um |f′|) und gedreht, und der rechte Winkel in ihm bleibt einer. Den Kreis ziehen: So ist es überall, und je kleiner der Kreis, desto genauer.
three_freedoms = Drei Freiheiten
three_freedoms_about = Riemann (1851): Zwischen zwei solchen Umrissen gibt es genau eine konforme Abbildung, sobald feststeht, wohin ein innerer Punkt geht (zwei Zahlen, die grünen Punkte) und wohin ein Randpunkt (eine Zahl, die magentafarbenen). Sie bewegen sich nacheinander: x₁, dann x₂, dann y₁.
harmonic_measure_about = Eine Irrfahrt beginne im grünen Punkt. Die Wahrscheinlichkeit, dass sie durch ein Randstück austritt, ist dessen harmonisches Maß. Eine konforme Abbildung erhält es; also genügt es, das Maß entlang beider Ränder abzugleichen: So rechnet riemap.
tour_crowding_about = Warum nicht über eine Scheibe? Die Arme dieses V schrumpfen auf deren Rand auf Längen von 10⁻¹⁷, und dem Rechner bleiben keine Stellen: Am Klecks sind die Marken außen am Umriss zusammengelaufen. Die inneren sind direkt abgeglichen und bleiben getrennt.
surfaces = Flächen
probed = |f′| = { $scale }, gedreht um { $turning }°
surfaces_about = Dasselbe geht mit einer Fläche im Raum mit einem Rand: Jeder ihrer Punkte bekommt einen Ort im Umriss. y₁ wandert einmal um den Umriss, und das Muster läuft über den Kopf. Danach lässt sich der Kopf drehen, und die Punkte auf ihm lassen sich ziehen. So werden Texturen auf Modelle gelegt.

## user error

try_again = Noch einmal
use_repaired = Repariert verwenden
repair = Reparieren

## viewport

drag_dot = Punkt ziehen
drop_for_side = Hier einen Umriss (SVG, JSON, CSV) oder ein Netz (OBJ, PLY, STL, glTF) für diese Seite ablegen oder ein Bild (PNG, JPEG) als Muster

## widgets

close_message = Diese Meldung schließen
more_words = Mehr
fewer_words = Weniger

## window

figures = Figuren
swap_waits = Solange nichts vorbereitet wird
export = Exportieren
gallery = Galerie
keys_and_gestures = Tasten und Gesten
pictures_done = { $done } von { $all } Bildern
save = Sichern
paper_figures = Figuren des Artikels

## request

surface_obj_tooltip = Wavefront OBJ: die Ecken in ihrer Reihenfolge, jede mit ihrer Texturkoordinate; eine OBJ-Datei behält alles andere
surface_ply_tooltip = PLY: x y z s t für jede Ecke; eine PLY-Datei behält alles andere
surface_glb_tooltip = Binäres glTF mit Texturkoordinaten; eine glTF-Datei behält Materialien und Bilder
mapped_ply_tooltip = PLY, ASCII: jede Ecke im Bild und ihr Ort im Urbild
mapped_glb_tooltip = Binäres glTF: das Netz im Bild, seine Orte im Urbild als _SOURCE
surface_csv_tooltip = Eine Tabelle: x, y, z, u, v für jede Ecke
surface_svg_tooltip = Die Kanten der Abwicklung im Umriss
animated_png = Animiertes PNG
png_tooltip = Das Bild in beliebiger Größe
animated_png_tooltip = Ein Umlauf der Punkte ohne Ende, in allen Farben
gif_tooltip = Ein Umlauf der Punkte ohne Ende, in 256 Farben
svg_tooltip = Umrisse, Linien des Musters, die Punkte, und das Netz, wo es gezeigt wird
disks_svg_tooltip = Beide Flächen, wie sie in der Einheitskreisscheibe liegen, mit den Linien des Musters, den Punkten und den Netzen, wo sie gezeigt werden
csv_tooltip = Eine Tabelle von Randpunkten, die aufeinander abgebildet werden: Bogenlängen, Orte, harmonisches Maß
obj_tooltip = Wavefront OBJ: das Netz im Bild, seine Texturkoordinaten im Urbild
png = PNG
gif = GIF
svg = SVG
csv = CSV
obj = OBJ
ply = PLY
glb = GLB
formula = Formel
formula_tooltip = Die Abbildung und ihre Umkehrung als rationale Funktionen, angepasst an die Randwerte der Integralgleichung: Zahlen, oder Code, der so läuft, wie er ist

## formula

format = Format
digits = Stellen
digits_tooltip = Bezogen auf die halbe größere Seite des Rechtecks um die Werte. GLSL hat höchstens 5: einfache Genauigkeit
inverse_of_f = die Umkehrung von f
formula_of_earlier_map = Dies ist die Formel einer früheren Abbildung: erneut speichern für die gezeigte
formula_function = { $name }: Grad { $degree }; Pole: { $poles }, keiner innen; größter Fehler: { $error }; Stellen: { $digits }
formula_reaches = { $name } erreicht { $digits } von { $asked } Stellen
formula_left_out = { $name } fehlt: Es fand sich keine rationale Funktion, die auch nur eine Stelle hat
formula_boundary_values = Randwerte ({ $name }): um bis zu { $error } falsch

## words

edited_name = { $name } (bearbeitet)
cauchy_green_gpu = Cauchy–Green: GPU
cauchy_green_cpu = Cauchy–Green: CPU
harmonic_coordinates = harmonische Koordinaten: { $percent } %
cauchy_green_cpu_at = Cauchy–Green: CPU { $percent } %
sizes = m { $boundary } · n { $interior } · vorbereitet in { $duration }
surface_sizes_about = { $count ->
    [one] m: Randecken. n: innere Ecken. { $shown } Dreieck.
   *[other] m: Randecken. n: innere Ecken. { $shown } Dreiecke.
}
edges_flipped = { $count ->
    [one] Intrinsische Delaunay-Kanten: { $shown } umgeklappt, negative Gewichte { $before } → { $after }
   *[other] Intrinsische Delaunay-Kanten: { $shown } umgeklappt, negative Gewichte { $before } → { $after }
}
pending = die volle Abbildung wird berechnet…
pending_tooltip = Diese Abbildung braucht länger als ein Bild. Solange sich ein Punkt bewegt und bis die volle da ist, wird eine grobe gezeigt.
size_tooltip = m: Randpunkte. n: innere Ecken des Netzes.
quality_tooltip = Q ist das Verhältnis der beiden Singulärwerte der Abbildung auf einem Dreieck: 1, wo Winkel erhalten bleiben. Q̄ ist sein flächengewichtetes Mittel über das Netz; das größte Q steht hier.
quality_unresolved = nicht aufgelöst
collapsed_area_tooltip = Der Flächenanteil der Dreiecke, deren Bild bis auf Rundung ein Punkt oder eine Strecke ist. Sie haben kein Q und zählen nicht zu Q̄, das nicht aufgelöst ist, wo sie mehr als 1 % sind.
flipped_tooltip = Dreiecke, deren Umlaufsinn die Abbildung umgekehrt hat. Bei einer guten Abbildung keine; wo es welche gibt, helfen mehr Randpunkte.
frame_tooltip = Was die letzte Berechnung der Abbildung gekostet hat: Kern (harmonisches Maß: die Wahrscheinlichkeit, dass eine Irrfahrt ab x durch ein Randstück austritt), Abgleich (die Maße der Ränder werden gleich gemacht), Fortsetzung (ins Innere), und was das Zeichnen den Prozessor gekostet hat.
source = Urbild
target = Bild
stage_sample = abtasten
stage_assemble = aufstellen
stage_order = ordnen
stage_table = Tabelle
waiting_worker = wartet auf den Hintergrundprozess…
reading = wird gelesen…
sampling_boundary = der Rand wird abgetastet…
triangulating = es wird trianguliert…
assembling_laplacian = der Laplace-Operator wird aufgestellt…
ordering = es wird geordnet…
factoring = es wird faktorisiert…
solved_iteratively = Der Cholesky-Faktor passt nicht in den Speicher: Es wird iterativ gelöst. Beim Ziehen folgt eine grobe Abbildung; nach dem Loslassen braucht die volle eine Weile
mesh_is_coarser = Das Netz ist gröber als verlangt: Seine Verfeinerung endete an der Grenze

## lesson

lesson = Lektion
make_lesson = Lektion erstellen…
make_lesson_tooltip = Bilder mit Text, die wie der Rundgang laufen; in einer Datei oder einem Link
lesson_about = Ein Bild einrichten, als Schritt hinzufügen und aufschreiben, was daran zu sehen ist. Die Schritte laufen wie der Rundgang.
lesson_title = Titel
lesson_caption_hint = Was hier zu sehen und zu probieren ist
add_step = Schritt hinzufügen
add_step_tooltip = Das jetzige Bild wird der nächste Schritt
show_step = Zeigen
show_step_tooltip = Zeigt das Bild dieses Schritts, um es zu ändern
renew_step = Ersetzen
renew_step_tooltip = Das jetzige Bild tritt an die Stelle des Bildes dieses Schritts; der Text bleibt
step_up = Diesen Schritt nach oben
step_down = Diesen Schritt nach unten
delete_step = Diesen Schritt löschen
title_changed = Titel geändert
step_added = Schritt hinzugefügt
step_moved = Schritt verschoben
step_deleted = Schritt gelöscht
lesson_replaced = Die Lektion wurde ersetzt
lesson_changed_elsewhere = In einem anderen Tab oder Fenster geändert
lesson_kept_own = Auch in einem anderen Tab oder Fenster geändert; „Rückgängig“ zeigt jene Fassung
undo_in_lesson = In der Lektion rückgängig
redo_in_lesson = In der Lektion wiederholen
lesson_is_full = Die Lektion hat so viele Schritte, wie sie haben kann
lesson_without_steps = Die Lektion hat noch keinen Schritt
lesson_waits_for_outline = Erst die Bearbeitung des Umrisses beenden oder abbrechen
lesson_waits_for_export = Der Export läuft noch: abwarten oder abbrechen
lesson_waits_for_shapes = Das Bild wird noch vorbereitet. Noch einmal versuchen, wenn es da ist
play_lesson = Lektion abspielen
play_lesson_tooltip = Spielt die Lektion vom ersten Schritt an; Escape beendet sie
save_lesson = Sichern…
save_lesson_tooltip = Eine Textdatei mit Link und Text für jeden Schritt, die sich in jedem Texteditor ändern lässt
lesson_link = Link kopieren
lesson_link_tooltip = Ein Link, der die ganze Lektion abspielt
open_lesson = Öffnen…
open_lesson_tooltip = Öffnet die Datei einer Lektion, um sie zu ändern
close_lesson = Lektion schließen; sie wird aufgehoben
end_lesson_tooltip = Beendet die Lektion und zeigt wieder das eigene Bild
lessons = Lektionen
caption_of = Text zu Schritt { $number }
caption_changed = Text zu Schritt { $number } geändert
step_renewed = Schritt { $number } ersetzt
lesson_refused = Die Lektion lässt sich nicht verwenden: { $reason }.
step_refused = Dieses Bild kann kein Schritt werden: { $reason }.
step_added_but = Im Schritt gilt: { $reasons }.
lesson_not_kept = Die Lektion bleibt nicht bis zum nächsten Besuch erhalten: { $reason }

## best map

best_map = Beste Abbildung
explain_best_map = Alle konformen Abbildungen der einen Seite auf die andere unterscheiden sich durch drei Zahlen: welcher Punkt x₁ auf x₂ kommt (zwei Zahlen), und eine Drehung. „Suchen“ sucht unter allen die beste: mit den gleichmäßigsten Flächen (das kleinste Mittel von (ln σ₁σ₂)², nach Fläche gewichtet; σ₁σ₂ sagt, wie sehr eine kleine Fläche wächst, bis auf einen gemeinsamen Maßstab), mit dem kleinsten Verhältnis vom größten zum kleinsten Maßstab (auf 98 % der Fläche, denn Ecken haben keinen), mit den gleichmäßigsten Flächen in einem Gebiet, das du malst, oder mit der kleinsten Abweichung von den Symmetrien beider Umrisse. Erst nach einer Formel für die ganze Familie, dann an der Abbildung selbst. Die Landschaft zeigt die Zahl für jeden Ort von x₁, mit y₁ und y₂, wo sie sind; „Suchen“ bewegt auch sie; seine Zahl kann deshalb kleiner sein.
aim_area = Flächen
aim_area_tooltip = Die gleichmäßigsten Flächen
aim_scale = Maßstäbe
aim_scale_tooltip = Das kleinste Verhältnis vom größten zum kleinsten Maßstab, auf 98 % der Fläche
aim_region = Gebiet
aim_region_tooltip = Die gleichmäßigsten Flächen in einem Gebiet des Urbilds, das du malst
aim_symmetry = Symmetrie
aim_symmetry_tooltip = Behält die Spiegelungen und Drehungen bei, die beide Umrisse haben, und die Flächen so gleichmäßig, wie sie es zulassen
symmetry_of_outlines = Symmetrien sind die zweier Umrisse
find_best = Suchen
find_best_tooltip = Sucht unter allen konformen Abbildungen die beste und bewegt die Punkte dorthin; ein Schritt für „Rückgängig“
cancel_best_tooltip = Beendet die Suche; die Punkte bleiben
course_tooltip = Der Wert der bisher besten Abbildung über der Anzahl der versuchten: grau nach einer Formel, blau der Abbildungen selbst; links der Wert am Anfang, rechts der erreichte
landscape = Landschaft über x₁
landscape_tooltip = Färbt jeden Ort von x₁ nach dem Wert, den die Abbildung mit y₁ und y₂ an ihren Orten dort hätte, dunkel, wo er am kleinsten ist; klicken oder ziehen bewegt x₁ dorthin
landscape_of_surface = Die Landschaft wird über einem Umriss gezeichnet; das Urbild ist eine Fläche
brush = Mit dem Pinsel malen
brush_tooltip = Ziehen über dem Urbild malt das Gebiet; Scrollen vergrößert, zwei Finger verschieben das Bild
brush_size = Pinsel
paint_here = Bei x₁ malen
paint_here_tooltip = Ein Tupfer des Pinsels dort, wo x₁ ist: für die Tastatur, deren Pfeiltasten x₁ bewegen
painted_here = x₁ liegt schon im Gebiet
clear_region = Gebiet löschen
clear_region_tooltip = Entfernt, was gemalt wurde
region_in_legend = Der Teil des Urbilds, dessen Flächen die Suche gleichmäßig macht
value_area = Flächenverzerrung
value_scale = Verhältnis der Maßstäbe
value_region = Flächenverzerrung im Gebiet
value_symmetry = Abweichung von der Symmetrie
region_is_empty = Erst ein Gebiet des Urbilds malen
best_map_interrupted = Die Suche endete, weil sich die Punkte oder die Formen geändert haben
best_sought = Die beste Abbildung wird gesucht.
best_area = Flächenverzerrung { $before } → { $after } ({ $count } Abbildungen versucht)
best_scale = Verhältnis der Maßstäbe { $before } → { $after } ({ $count } Abbildungen versucht)
best_region = Flächenverzerrung im Gebiet { $before } → { $after } ({ $count } Abbildungen versucht)
best_symmetry = Abweichung von der Symmetrie { $before } → { $after } der Größe ({ $count } Abbildungen versucht)
best_already = Keine bessere Abbildung gefunden: { $value } ({ $count } Abbildungen versucht)
lowest_of_landscape = kleinster: { $value }
accessible_landscape = Die Landschaft über x₁ ist am niedrigsten bei ({ $x }; { $y }), mit { $value }.

## tiling
tiling = Parkett
tiling_tooltip = Ein regelmäßiges Parkett der hyperbolischen Ebene, von der Abbildung getragen
tiling_heading = Hyperbolisches Parkett
explain_tiling = Die hyperbolische Ebene hat mehr Platz als unsere: Um eine Ecke passen Steine, die hier nicht passen würden, etwa drei Siebenecke. Die Poincaré-Scheibe zeichnet diese ganze Ebene in einen Kreis: Winkel stimmen, Längen schrumpfen zum Rand hin. Für jemanden, der dort wohnt, sind alle Steine gleich groß, und der Rand ist unendlich fern. Eine konforme Abbildung bringt die Scheibe mit dem Parkett in jede Form. Der mittlere Stein liegt bei x, eine seiner Kanten weist zu y. Zieht man x₁, so gleitet jeder Stein, ohne verbogen zu werden: Für die Bewohner ist es nur eine Verschiebung, eine Bewegung der hyperbolischen Ebene (eine Möbius-Abbildung der Scheibe). Wo Steine zu klein wären, um gesehen zu werden, gehen sie in eine Farbe über.
tile_sides = Ecken
tile_sides_tooltip = Die Zahl der Ecken eines Steins, p
tiles_at_corner = Je Ecke
tiles_at_corner_tooltip = Die Zahl der Steine um jede Ecke, q. Hyperbolisch sind die Paare mit (p − 2)(q − 2) > 4
tiling_tiles = Farben
tiling_tiles_tooltip = Bei gerader Zahl je Ecke wechseln die Steine zwischen zwei Farben; bei ungerader ist das unmöglich, und die Farbe eines Steins sagt, wie weit er vom mittleren entfernt ist
tiling_edges = Kanten
tiling_edges_tooltip = Nur die Kanten der Steine
tiling_triangles = Spiegel
tiling_triangles_tooltip = Jeder Stein an seinen Spiegelachsen geteilt: Jedes Dreieck ist das Spiegelbild seiner Nachbarn
tiling_picture = Foto
tiling_picture_tooltip = Ein eigenes PNG oder JPEG in jedem Stein, unten zu x hin
hyperbolic_tiles = Hyperbolische Ebene
hyperbolic_tiles_about = Siebenecke, drei an jeder Ecke: für die Bewohner alle gleich groß
tetrahedron = Tetraeder
octahedron = Oktaeder
cube = Würfel
icosahedron = Ikosaeder
dodecahedron = Dodekaeder
accessible_tiling = Das Muster ist das hyperbolische Parkett aus Vielecken mit { $sides } Ecken, { $around } um jede Ecke; das mittlere liegt am inneren Punkt.

## symmetry

symmetry = Symmetrie
explain_symmetry = An einer Spiegelachse ist ein Umriss sein eigenes Spiegelbild; um den genannten Winkel um sein Zentrum gedreht, liegt er auf sich selbst. Kleine Abweichungen sind erlaubt und stehen dabei, als Anteil der Größe (des größten Abstands vom Schwerpunkt der Fläche). Eine Abbildung ist dort auch symmetrisch, wo beide Umrisse es sind und die Punkte auf ihren Achsen liegen. Beim Ziehen rasten x₁ und x₂ in Zentren und auf Achsen ein, y₁, y₂ und Pins an Enden von Achsen und in Ecken; mit der Alt-Taste bewegen sie sich frei.
show_symmetries = Zeigen und einrasten
show_symmetries_tooltip = Zeichnet Achsen und Zentrum jedes Umrisses; gezogene Punkte rasten dort ein (frei mit gedrückter Alt-Taste)
no_symmetry = keine
in_center = im Zentrum
in_corner = in einer Ecke
drag_with_alt = Alt beim Ziehen
drag_with_alt_about = Der Punkt rastet nicht in Ecken, auf Symmetrieachsen oder in Zentren ein
symmetries_of = Symmetrie: { $side }
symmetry_axis = Achse bei { $angle }°, Abweichung { $off } %
symmetry_turns = Drehungen um { $angle }°, Abweichung { $off } %
symmetry_circle = Ein Kreis, Abweichung { $off } %: jede Gerade durch das Zentrum ist eine Achse
more_axes = und { $count } weitere Achsen
symmetry_tolerance = Bis { $share } % der Größe gilt als symmetrisch.
on_axis = auf der Achse bei { $angle }°
at_axis_end = am Ende der Achse bei { $angle }°
caught_dot = { $dot } liegt { $place }.

## chains
continue_from_target = Vom Ziel aus weiter
continue_tooltip = Das Ziel wird auch zur Quelle, mit Form, Punkten und Marken; wähl dann ein anderes Ziel: Eine Kette von Abbildungen geht von dort weiter
choose_next_target = Wähl ein Ziel

## quadrilaterals
quadrilateral = Rechteck und Gitter
explain_quadrilateral = Vier Marken machen den Umriss zu einem Viereck mit krummen Seiten. Eine konforme Abbildung davon auf ein Rechteck, die die Marken auf die Ecken abbildet, gibt es für genau ein Seitenverhältnis, und dann nur eine: Drei Ecken legen die Abbildung fest, und die vierte passt nur bei diesem Verhältnis. Es ist der Modul: wie weit die Seite von Marke 1 bis 2 von der Seite von Marke 3 bis 4 entfernt ist, konform gemessen. Das Netz gleicher Zellen dieses Rechtecks, zurückgetragen, ist ein Gitter im Umriss, dessen Linien sich rechtwinklig schneiden, wie man es für Simulationen von Strömung und Wärme braucht.
map_onto_rectangle = Auf sein Rechteck abbilden
map_onto_rectangle_tooltip = Setzt das Rechteck dieses Moduls auf die andere Seite und heftet drei Marken an seine Ecken, die vierte folgt; ein Schritt beim Rückgängigmachen
rectangle = Rechteck
orthogonal_grid = Rechtwinkliges Gitter
orthogonal_grid_tooltip = Linien, die sich rechtwinklig schneiden, mit den Marken als Ecken des Gitters
cells_along = Zellen von Marke 1 bis 2
cells_across_marks = Zellen von Marke 2 bis 3
save_grid = Gitter speichern
pinned_to_corners = Die Marken 1 bis 3 sind an ihre Ecken geheftet; Marke 4 verfehlt ihre um { $miss }.
grid_accuracy = Knoten auf { $error } genau, Winkel auf { $angle }°.
grid_error = Knoten auf { $error } genau.
lines_drawn = Eine von { $stride } Linien entlang { $side } ist gezeichnet.
computing_at = Wird berechnet… { $percent } %
modulus_uncertain = der Modul ist { $value } mit einem Fehler von { $error }: den inneren Punkt zwischen die Marken ziehen
explain_mark = Eine Ecke des Vierecks. Zieh sie am Umriss entlang, oder geh mit Tab zu ihr und nimm die Pfeiltasten; sie bleibt zwischen ihren Nachbarn.
mark_of_side = Marke { $mark } ({ $side })
accessible_marks = Marken ({ $side }) bei { $first }; { $second }; { $third } und { $fourth } % des Randes.
quadrilateral_limit = Für jede Breite, um die das Viereck länger ist, geht ein Faktor fünf an Genauigkeit verloren: bei 18 (oder 1/18) bleiben fünf Stellen, bei 22 zwei. Verschieb Marken, sodass das Viereck kürzer wird, oder teile den Umriss quer und mach das Gitter jedes Teils.
accessible_grid = Rechtwinkliges Gitter · { $side }: { $first } × { $second } Zellen. { $accuracy }
save_grid_as = Gitter als { $format } speichern

## projections
map_projection = Landkarte…
map_projection_tooltip = Die Karte eines Landes oder einer Insel, deren Maßstab am wenigsten schwankt
projection = Landkarte
explain_projection = Keine ebene Karte eines Teils der Erde hat überall denselben Maßstab. Unter allen winkeltreuen Karten schwankt er bei der am wenigsten, deren Maßstab am ganzen Rand des Gebiets gleich ist; das hat Tschebyschow 1856 gesagt, Grave bewiesen und Milnor 1969 neu gefasst. Sie folgt aus einer Randwertaufgabe: Der Logarithmus des Maßstabs ist am Rand bekannt und dort größer als überall innen. Das Verhältnis ist das des größten zum kleinsten Maßstab; daneben steht, was die beste stereografische Projektion erreicht.
projection_begin = Eine GeoJSON-Datei mit dem Umriss eines Landes oder einer Insel in Länge und Breite öffnen, oder eine erfundene Insel ansehen.
open_region = Gebiet öffnen…
open_region_tooltip = Eine GeoJSON-Datei in Länge und Breite; von mehreren Polygonen wird das größte abgebildet
show_island = Eine Insel zeigen
show_island_tooltip = Eine Insel nach einer Formel im nördlichen Atlantik
island = Insel
regions = Gebiete
scale_ratio = Maßstabsverhältnis
stereographic_ratio = Stereografisch
least_scale = Kleinster Maßstab bei
looks_geographic = Diese Koordinaten könnten Längen und Breiten sein.
feature = Merkmal
all_features = Alle Merkmale
repair_region_tooltip = Kleine Schleifen abschneiden, wo der Rand sich kreuzt oder berührt
project_it = Als Landkarte zeigen
project_it_tooltip = Öffnet die Karte dieser Datei, deren Maßstab am wenigsten schwankt
scale_lines_legend = Linien gleichen Maßstabs; am Rand ist er 1.
save_projection = Speichern als
ratio_at_most = { $value } ± { $error }, kleiner geht es nicht
place_in_degrees = Länge { $longitude }°, Breite { $latitude }°
graticule_steps = Meridiane alle { $longitude }°, Breitenkreise alle { $latitude }°.
accessible_projection = Landkarte von { $name }: Maßstabsverhältnis { $ratio }, stereografisch { $stereographic }.
projection_left_out = { $count ->
    [one] Das größte Gebiet wurde genommen, { $percent } % der Fläche; ein anderer Rand blieb weg.
   *[other] Das größte Gebiet wurde genommen, { $percent } % der Fläche; { $count } andere Ränder blieben weg.
}
projection_joined = { $count } Ringe wurden an der Datumsgrenze verbunden.
projection_mended = { $count ->
    [one] Ein Punkt wurde abgeschnitten, wo der Rand sich kreuzte oder berührte.
   *[other] { $count } Punkte wurden abgeschnitten, wo der Rand sich kreuzte oder berührte.
}
projection_holes = { $count ->
    [one] Ein Loch wurde gefüllt.
   *[other] { $count } Löcher wurden gefüllt.
}
projection_overlaps = Die Karte überlappt sich, am Rand bei Länge { $longitude }°, Breite { $latitude }° und anderswo.
projecting = { $name } wird abgebildet…
save_projection_as = Karte als { $format } speichern
