### Errors, notes and messages, in German.

## app

verbatim = { $text }
about = { $name }: { $what }
both_items = { $first }, { $second }
sentence = { $what }.
both_clauses = { $first }; { $second }
both_sentences = { $first } { $second }
sentence_and = { $first }. { $second }
address_unknown = In der Adresse steht „{ $asked }“, aber { $option } kennt nur: { $known }.
address_unknown_and_more = In der Adresse steht „{ $asked }“ und { $more } weitere, aber { $option } kennt nur: { $known }.
address_keeps = Die Adresse der Seite hält „{ $control }“ fest.
graphics_device_lost = Das Grafikgerät ging verloren ({ $reason }). riemap neu starten: Die Abbildung und ihre Schritte zum Rückgängigmachen bleiben erhalten.
outline_crossed_itself = Der Umriss kreuzte sich dort: der letzte gute blieb.
no_graphics_device = Es gibt kein Grafikgerät zum Zeichnen.
planar_map_format = eine Abbildung in der Ebene wird nicht als .{ $format } geschrieben, sondern als .svg, .csv oder .obj
bare_triangles = { $name } hat nur Dreiecke: was die Datei der Fläche sonst noch hat, bleibt nicht erhalten (Dreiecksstreifen, Freiformflächen, Puffer in anderen Dateien, mehrfach gesetzte Netze und Abbildungen zwischen zwei Flächen).
nothing_would_move = nichts würde sich bewegen
surface_too_large_to_show = Diese Fläche ist zu groß für die Grafikeinheit: Sie wird abgebildet, aber nicht gezeigt.
not_saved = { $name } wurde nicht gesichert ({ $reason })
last_session_not_opened = Was vom letzten Mal aufgehoben war, ließ sich nicht öffnen: { $reason }
link_not_opened = Der Link ließ sich nicht öffnen: { $reason }
link_misses_outline = Der Link enthält den Umriss „{ $name }“ nicht ({ $side }): seine Datei dort öffnen.
files_not_kept = Die Sitzung wird für das nächste Mal ohne ihre Flächen und Bilder aufgehoben ({ $reason }). Als Datei gesichert bleibt alles erhalten.
only_session_kept = Die Sitzung wird für das nächste Mal aufgehoben, aber ohne ihre Flächen, Bilder und rückgängig zu machenden Schritte ({ $reason }). Als Datei gesichert bleibt alles erhalten.
session_not_kept = Die Sitzung wird nicht für das nächste Mal aufgehoben ({ $reason }). Stattdessen als Datei sichern.
pasted_text_not_shown = { $reason }. Der Text wird nicht gezeigt: er hat { $bytes } Bytes, und das Feld fasst höchstens { $limit }
disk_stands_in = für den Umriss „{ $name }“ ({ $side }), der nicht hier ist, steht eine Scheibe
surface_not_in_link = die Fläche „{ $name }“ ist nicht darin und reist als Datei
image_not_in_link = das Bild ist nicht darin
link_copied_but = Der Link wurde kopiert, aber { $reasons }.
grey_in_colours = { $what }: grau in den Farben der Verzerrung
open_in_picture = { $what }: nur in der Abbildung; im Bild und in Dateien sind sie offen
preparation_stopped = Die Vorbereitung brach unerwartet ab ({ $reason }). Gezeigt wird die letzte Abbildung.
session_not_saved = Die Sitzung wurde nicht gesichert: { $reason }
no_link_to_session = Zu dieser Sitzung gibt es keinen Link: { $reason }
another_answer = eine Antwort auf eine andere Frage
no_window = Das Fenster ließ sich nicht öffnen ({ $cause })
no_map = zu dieser Sitzung gibt es keine Abbildung
surface_travels_as_file = die Fläche „{ $name }“ der Sitzung reist als eigene Datei
no_surface_from_file = die Sitzung hat keine Fläche aus einer Datei
open_surface_file = Diese Fläche reist als eigene Datei: diese Datei hier öffnen oder ablegen.
surface_preparation_stopped = Die Vorbereitung der Fläche brach unerwartet ab ({ $reason }). Ist sie sehr groß, reicht vielleicht der Speicher nicht. Gezeigt wird die letzte Abbildung.
no_disk_coordinates = Keine Scheibenkoordinaten ({ $side }): { $reason }.
through_disk_fails = Der Weg über die Scheibe scheitert ({ $side }): { $reason }.
file_unreadable = die Datei lässt sich nicht lesen ({ $cause })
reading_stopped = das Lesen brach unerwartet ab ({ $reason })

## platform

internal_error = ein innerer Fehler
no_folder = es gibt keinen Ordner dafür
no_image = das ist kein lesbares PNG- oder JPEG-Bild ({ $cause })
browser_stores_nothing = der Browser lässt diese Seite nichts speichern
too_long_to_store = ihre { $characters } Zeichen sind mehr, als der Browser diese Seite speichern lässt
no_page = es gibt keine Seite
no_canvas_for_image = der Browser hat keine Zeichenfläche dafür
size_does_not_fit = seine Größe passt nicht
answer_unreadable = die Antwort war nicht zu lesen
request_unreadable = die Anfrage war nicht zu lesen
worker_ended = er wurde beendet
worker_silent = er antwortete nicht mehr
script_not_loaded = das Skript ließ sich nicht laden
no_page_to_draw_in = Es gibt keine Seite, in der gezeichnet werden könnte.
page_without_canvas = Die Seite hat keine Zeichenfläche.
no_such_row = diese Zeile gibt es nicht
dialog_too_late = Der Browser hat seinen Dateidialog nicht geöffnet, weil der Klick zu lange her war. Die Schaltfläche noch einmal drücken.
no_dialog = Der Dateidialog ließ sich nicht öffnen: { $reason }
not_shared = Der Link wurde nicht geteilt: { $reason }
link_too_long_for_code = Dieser Link hat { $bytes } Bytes, ein QR-Code fasst { $limit }: Bitte kopieren.
link_lacks = Zu diesem Link: { $reasons }.

## geometry

polygon_too_few_points = ein Umriss braucht mindestens 3 Punkte; dieser hat { $count }
polygon_too_many_points = ein Umriss darf höchstens { $limit } Punkte haben; dieser hat { $count }
polygon_not_finite = Punkt { $index } ist nicht endlich: ({ $x }; { $y })
polygon_too_far_out = Punkt { $index } bei ({ $x }; { $y }) liegt zu weit draußen: Koordinaten bis { $limit } sind möglich
polygon_too_small = der Umriss ist nur { $extent } breit; es müssen mindestens { $limit } sein
polygon_repeated_point = die Punkte { $first } und { $second } sind gleich: ({ $x }; { $y })
polygon_zero_area = der Umriss schließt keine Fläche ein: Alle Punkte liegen auf einer Geraden
polygon_folds_back = der Umriss läuft bei Punkt { $index }, ({ $x }; { $y }), auf sich selbst zurück
polygon_edges_cross = der Umriss kreuzt sich bei ({ $x }; { $y }): die Kante nach Punkt { $first } und die nach Punkt { $second }
polygon_edges_touch = der Umriss berührt sich bei ({ $x }; { $y }): die Kante nach Punkt { $first } und die nach Punkt { $second }

## outline

outline_file_too_large = die Datei hat { $bytes } Byte; Dateien bis { $limit } MiB lassen sich lesen
outline_file_not_utf8 = die Datei ist kein UTF-8-Text: Das Byte an Stelle { $offset } gehört nicht dorthin
outline_file_empty = die Datei ist leer
outline_file_json = das ist kein gültiges JSON ({ $message }), in Zeile { $line }, Spalte { $column }
outline_file_number_out_of_range = die Zahl in Zeile { $line }, Spalte { $column } ist außerhalb des Bereichs
outline_file_not_a_number = „{ $found }“ in Zeile { $line }, Spalte { $column } ist keine Zahl
outline_file_missing_number = in Zeile { $line }, Spalte { $column } fehlt eine Zahl
outline_file_numbers_on_line = { $count ->
    [one] Zeile { $line } hat 1 Zahl; ein Punkt sind zwei
   *[other] Zeile { $line } hat { $count } Zahlen; ein Punkt sind zwei
}
outline_file_not_understood = Zeile { $line } ist nicht zu verstehen: „{ $text }“
outline_file_reference_system = die Koordinaten sind in { $name }: bitte in Länge und Breite (EPSG:4326) umrechnen
outline_file_no_parts = einen Teil „{ $wanted }“ gibt es nicht: Die Datei enthält einen einzigen Umriss
outline_file_no_such_number = einen Teil „{ $wanted }“ gibt es nicht: Die Teile haben die Nummern 1 bis { $count }
outline_file_no_such_part = einen Teil „{ $wanted }“ gibt es nicht: Die Teile haben die Nummern 1 bis { $count } und die Namen { $names }
outline_shape_taken = Form { $number } von { $count } wurde genommen.
outline_named_shape_taken = Form { $number } von { $count } wurde genommen, „{ $name }“.
outline_repeated_points_dropped = { $count ->
    [one] Ein Punkt, der den vorigen wiederholte, wurde weggelassen.
   *[other] { $count } Punkte, die den vorigen wiederholten, wurden weggelassen.
}
outline_columns_dropped = { $count ->
    [one] Eine Spalte neben x und y wurde weggelassen.
   *[other] { $count } Spalten neben x und y wurden weggelassen.
}
lists_of_different_length = { $x } Zahlen in „x“ und { $y } in „y“
outline_file_odd_numbers = { $count ->
    [one] diese Zeile hat 1 Zahl; ein Punkt sind zwei
   *[other] diese Zeile hat { $count } Zahlen, eine ungerade Anzahl; ein Punkt sind zwei
}
outline_file_not_a_point = Punkt { $point }: { $found }; ein Punkt ist [x, y]
outline_file_not_an_outline = dieses JSON enthält keinen Umriss ({ $found }): erwartet wird [[x, y], …], {"{"}"points": [[x, y], …]{"}"} oder GeoJSON
outline_file_geo_json = dieses GeoJSON ist fehlerhaft: { $message }
outline_file_ring_not_closed = Ring { $ring } ist nicht geschlossen: Er beginnt bei ({ $x }; { $y }) und endet bei ({ $end_x }; { $end_y })
outline_file_svg = dieses SVG lässt sich nicht lesen ({ $message })
outline_file_no_path = dieses SVG hat keinen Pfad: Texte in Pfade umwandeln
outline_file_no_closed_path = kein Pfad dieses SVG ist geschlossen ({ $paths } offen)
sampling_too_few = mindestens 3 Randpunkte sind nötig, nicht { $count }
sampling_too_many = höchstens { $limit } Randpunkte sind möglich, nicht { $count }
sampling_more_corners_than_samples = der Umriss hat { $corners } Ecken: { $count } Randpunkte sind zu wenige, um sie zu behalten
outline_file_no_polygon = dieses GeoJSON enthält kein Polygon (sein Typ ist { $kind })
outline_reversed = Die Punkte liefen im Uhrzeigersinn und wurden umgekehrt.
outline_largest_of = Von { $rings } geschlossenen Ringen wurde der größte genommen.
outline_closing_point_dropped = Der letzte Punkt wiederholte den ersten und wurde weggelassen.
outline_repaired = { $count ->
    [one] Ein wiederholter Punkt oder eine Spitze wurde abgeschnitten.
   *[other] { $count } Punkte von Schleifen und Spitzen wurden abgeschnitten.
}
outline_upwards = y zeigt nach oben: (x, y) der Zeichnung ist hier (x, −y).
outline_holes_ignored = { $count ->
    [one] Ein Loch wurde weggelassen.
   *[other] { $count } Löcher wurden weggelassen.
}
type_not_given = nicht angegeben
json_null = null
json_truth_value = ein Wahrheitswert
json_number = eine Zahl
json_text = ein Text
json_list = eine Liste
json_object = ein Objekt
point_is = das ist { $kind }
point_has_no_number = { $kind } steht, wo eine Zahl stehen sollte
points_are = "points" ist { $kind }
object_without_points = ein Objekt ohne "points"
geojson_no_list = „{ $key }“ ist { $kind }, keine Liste
geojson_missing = „{ $key }“ fehlt
geojson_polygon = ein Polygon ist { $kind }, keine Liste
geojson_ring = ein Ring ist { $kind }, keine Liste
geojson_unknown_type = „{ $name }“ ist kein GeoJSON-Typ
geojson_no_type = ein Objekt hat kein "type"
geojson_empty_ring = Ring { $ring } hat keine Punkte
svg_elements_nested = Elemente sind zu tief verschachtelt
svg_uses_nested = "use"-Elemente sind zu tief verschachtelt
point_has_numbers = { $count ->
    [one] nur 1 Zahl
   *[other] { $count } Zahlen
}

## drawing

drawing_too_short = dieser Strich ist zu kurz für einen Umriss: die Form in einem Zug umfahren
drawing_too_few_points = { $count ->
    [one] ein Umriss braucht mindestens 3 Punkte; 1 ist gesetzt
   *[other] ein Umriss braucht mindestens 3 Punkte; { $count } sind gesetzt
}
drawing_last_handles = ein Umriss behält mindestens { $least } Griffe: dieser muss bleiben
trace_one_colour = das ganze Bild hat eine Farbe: es gibt keine Form nachzuzeichnen
trace_no_shape = im Bild wurde keine Form gefunden: die größte nimmt weniger als ein Tausendstel davon ein

## mesh

mesh_self_crossing = der abgetastete Rand kreuzt sich bei ({ $x }; { $y }): mehr Randpunkte verwenden
mesh_repeated_point = zwei Randpunkte fallen bei ({ $x }; { $y }) zusammen
mesh_too_few_points = ein Rand braucht mindestens 3 Punkte; dieser hat { $count }
mesh_not_finite = Randpunkt { $index } ist nicht endlich
mesh_not_counter_clockwise = der Rand läuft im Uhrzeigersinn oder schließt keine Fläche ein
mesh_out_of_range = die Koordinaten des Randes sind alle null oder jenseits von 2^±300
mesh_grading = das Wachstum der Dreiecke muss zwischen 0.01 und 1 liegen, nicht bei { $grading }
mesh_too_many_vertices = dieses Netz hätte etwa { $estimate } innere Ecken; höchstens { $limit } werden gemacht: weniger Randpunkte oder abgestufte Dreiecke verwenden
mesh_too_thin = der Rand ist bei ({ $x }; { $y }) zu dünn, um in doppelter Genauigkeit trianguliert zu werden

## laplace

laplace_structure = das Netz ist in sich widersprüchlich ({ $reason })
laplace_degenerate = ein Dreieck bei ({ $x }; { $y }) ist zu dünn, um Winkel zu haben: mehr Randpunkte oder einen weniger engen Umriss verwenden
laplace_degenerate_at = ein Dreieck an Ecke { $vertex } der Fläche ist zu dünn, um Winkel zu haben
laplace_not_positive_definite = der Laplace-Operator ist an der inneren Ecke { $vertex } nicht positiv definit: Dort ist ein Dreieck entartet
laplace_too_large = der Faktor von { $unknowns } Unbekannten braucht { $megabytes } MB, mehr als passt: weniger Randpunkte, abgestufte Dreiecke oder das iterative Verfahren verwenden
not_converged = das iterative Verfahren ist nicht konvergiert: Sein relatives Residuum ist { $residual }

## surface

surface_file_too_large = die Datei hat { $bytes } Byte; Flächen bis { $limit } MiB lassen sich lesen
surface_file_too_much_memory = die Fläche hat { $triangles } Dreiecke und { $vertices } Ecken, die etwa { $needed } MB Speicher brauchen; verfügbar sind { $available } MB
surface_file_unknown_format = „.{ $extension }“ ist kein bekanntes Flächenformat: obj, ply, stl, off, gltf, glb
surface_file_not_a_number = { $place }: „{ $found }“ ist keine Zahl
surface_file_missing = { $place }: { $what } fehlt
surface_file_index_out_of_range = { $vertices ->
    [one] { $place }: ein Vieleck nennt Ecke { $index }, die Datei hat aber nur 1 Ecke
   *[other] { $place }: ein Vieleck nennt Ecke { $index }, die Datei hat aber { $vertices } Ecken
}
surface_file_unsupported = { $place }: { $what } lässt sich nicht lesen
surface_file_no_triangles = die Datei enthält keine Vielecke
surface_note_triangulated = { $polygons ->
    [one] 1 Vieleck wurde in Dreiecke zerlegt
   *[other] { $polygons } Vielecke wurden in Dreiecke zerlegt
}
surface_note_welded = { $before } Eckpunkte an { $after } Orten wurden zu { $after } Ecken
surface_note_left_apart = { $vertices ->
    [one] 1 Ecke bleibt von einer anderen am selben Ort getrennt: verbunden wäre die Fläche keine Scheibe
   *[other] { $vertices } Ecken bleiben von anderen an denselben Orten getrennt: verbunden wäre die Fläche keine Scheibe
}
surface_note_dropped_faces = { $count ->
    [one] 1 Fläche mit weniger als 3 Ecken wurde weggelassen
   *[other] { $count } Flächen mit weniger als 3 Ecken wurden weggelassen
}
surface_note_unended = die letzte Zeile, endsolid, fehlt; wurde die Datei abgeschnitten, dann auch die Fläche
surface_note_surplus = { $place }: Danach steht mehr, als die Datei nach eigener Angabe hat; es wurde übergangen
topology_empty = die Fläche hat keine Dreiecke
topology_index_out_of_range = { $vertices ->
    [one] Dreieck { $triangle } nennt Ecke { $vertex }, es gibt aber nur 1 Ecke
   *[other] Dreieck { $triangle } nennt Ecke { $vertex }, es gibt aber { $vertices } Ecken
}
topology_not_finite = { $count ->
    [one] Ecke { $vertex } liegt an keinem endlichen Ort, mit dem sich rechnen lässt (bis ±{ $limit })
   *[other] { $count } Ecken liegen an keinem endlichen Ort, mit dem sich rechnen lässt (bis ±{ $limit }), die erste ist Ecke { $vertex }
}
topology_too_small = die Fläche hat eine Ausdehnung von { $extent }: Rechnen lässt sich ab { $limit }
topology_repeated_corner = { $count ->
    [one] Dreieck { $triangle } { $corners } nennt eine Ecke zweimal: weglassen
   *[other] { $count } Dreiecke nennen eine Ecke zweimal, das erste ist Dreieck { $triangle } { $corners }: weglassen
}
topology_degenerate = { $count ->
    [one] Dreieck { $triangle } { $corners } hat keinen Flächeninhalt: seine Ecken verschmelzen oder es weglassen
   *[other] { $count } Dreiecke haben keinen Flächeninhalt, das erste ist Dreieck { $triangle } { $corners }: ihre Ecken verschmelzen oder sie weglassen
}
topology_duplicates = { $count ->
    [one] Dreieck { $triangle } { $corners } hat dieselben Ecken wie Dreieck { $other }: weglassen
   *[other] { $count } Dreiecke haben dieselben Ecken wie ein anderes, das erste ist Dreieck { $triangle } { $corners }, wie Dreieck { $other }: weglassen
}
topology_non_manifold_edge = { $count ->
    [one] die Kante von Ecke { $start } nach { $end } hat mehr als zwei Dreiecke, { $triangles }: alle bis auf zwei löschen
   *[other] { $count } Kanten haben mehr als zwei Dreiecke, die erste, von Ecke { $start } nach { $end }, die Dreiecke { $triangles }: jeweils alle bis auf zwei löschen
}
topology_orientation = { $count ->
    [one] die Kante von Ecke { $start } nach { $end } liegt zwischen Dreiecken verschiedener Orientierung, { $left } und { $right }: die Fläche einheitlich orientieren
   *[other] { $count } Kanten liegen zwischen Dreiecken verschiedener Orientierung, die erste von Ecke { $start } nach { $end }, zwischen den Dreiecken { $left } und { $right }: die Fläche einheitlich orientieren
}
topology_one_sided = die Fläche hat nur eine Seite (wie ein Möbiusband): Keine Orientierung von Dreieck { $triangle } passt, aufschneiden
topology_non_manifold_vertex = { $count ->
    [one] Ecke { $vertex } verbindet Teile ohne gemeinsame Kante, { $fans } Fächer von Dreiecken: jedem dort eine eigene Ecke geben
   *[other] { $count } Ecken verbinden Teile ohne gemeinsame Kante, die erste ist Ecke { $vertex } mit { $fans } Fächern von Dreiecken: jedem dort eine eigene Ecke geben
}
topology_closed = die Fläche ist geschlossen (Geschlecht { $genus }); sie muss einen Rand haben: aufschneiden
topology_genus = { $genus ->
    [one] die Fläche hat 1 Henkel; eine Scheibe hat keinen: aufschneiden
   *[other] die Fläche hat { $genus } Henkel; eine Scheibe hat keinen: aufschneiden
}
repair_dropped_triangles = { $count ->
    [one] 1 Dreieck, das eine Ecke zweimal nennt, wurde weggelassen
   *[other] { $count } Dreiecke, die eine Ecke zweimal nennen, wurden weggelassen
}
repair_merged_vertices = { $count ->
    [one] 1 Ecke wurde mit ihrer Nachbarin am selben Ort vereinigt
   *[other] { $count } Ecken wurden mit ihren Nachbarinnen am selben Ort vereinigt
}
repair_flipped_flat = { $count ->
    [one] bei 1 Dreieck ohne Fläche wurde die längste Kante umgelegt
   *[other] bei { $count } Dreiecken ohne Fläche wurde die längste Kante umgelegt
}
repair_joined = { $count ->
    [one] 1 Spalt ohne Fläche wurde verbunden
   *[other] { $count } Spalte ohne Fläche wurden verbunden
}
repair_split_vertices = { $count ->
    [one] 1 Ecke kam hinzu, wo Teile der Fläche in einer zusammentrafen
   *[other] { $count } Ecken kamen hinzu, wo Teile der Fläche in einer zusammentrafen
}
repair_dropped_duplicates = { $count ->
    [one] 1 Dreieck mit denselben Ecken wie ein anderes wurde weggelassen
   *[other] { $count } Dreiecke mit denselben Ecken wie ein anderes wurden weggelassen
}
repair_oriented = { $count ->
    [one] 1 Dreieck wurde umgedreht, damit alle gleich orientiert sind
   *[other] { $count } Dreiecke wurden umgedreht, damit alle gleich orientiert sind
}
repair_kept_largest = { $dropped ->
    [one] das größte von { $components } Teilen wurde behalten; 1 Dreieck wurde weggelassen
   *[other] das größte von { $components } Teilen wurde behalten; { $dropped } Dreiecke wurden weggelassen
}
repair_dropped_vertices = { $count ->
    [one] 1 Ecke in keinem Dreieck wurde weggelassen
   *[other] { $count } Ecken in keinem Dreieck wurden weggelassen
}
surface_file_malformed = { $place }: { $fault }
topology_components = die Fläche hat { $count } Teile: den größten behalten (Dreiecke: { $sizes }; das erste außerhalb von ihm ist Dreieck { $first })
topology_several = die Fläche hat Fehler von { $count } Arten: { $faults }
topology_fault = ({ $number }) { $fault }
topology_loops = die Fläche hat { $count } Randkurven, eine Scheibe hat eine: alle außer der längsten füllen. Das sind die Randkurven: { $loops }
topology_flat_hole = { $count ->
    [one] ein Loch hat keine Fläche, da seine Ecken auf einer Linie liegen: Sie sind zu verbinden ({ $hole })
   *[other] { $count } Löcher haben keine Fläche, da ihre Ecken auf einer Linie liegen: Sie sind zu verbinden (das erste: { $hole })
}
topology_no_loop = die Fläche hat { $count } Randkurven ({ $loops }), nicht { $asked }
boundary_loop = Länge { $length } mit { $vertices } Ecken bei Ecke { $first }
repair_filled_hole = { $triangles ->
    [one] 1 Loch wurde mit 1 Dreieck gefüllt
   *[other] 1 Loch wurde mit { $triangles } Dreiecken gefüllt
}
repair_filled_holes = { $holes } Löcher wurden mit { $triangles } Dreiecken gefüllt
place_line = Zeile { $line }
place_byte = Byte { $offset }
item_glb_version = die Version
item_file_length = die Länge der Datei
item_chunk_length = die Länge eines Blocks
item_chunk_type = der Typ eines Blocks
item_json_chunk = der JSON-Block
item_default_scene = die Standardszene
item_node = der Knoten
item_position = das Attribut POSITION
item_data = der Inhalt
item_accessor = der accessor
item_buffer_view = die bufferView
item_buffer = der buffer
item_viewed_data = ein Teil der Daten, die seine bufferView beschreibt
item_element = Element { $index } von { $count }
item_vertex = eine Ecke
item_face = ein Vieleck
item_corner_count = die Anzahl der Eckpunkte
item_corner = Eckpunkt { $index } von { $count }
item_off_keyword = das Schlüsselwort OFF
item_off_number = eine Zahl eines Punktes oder einer Farbe
item_vertex_count = die Anzahl der Ecken
item_face_count = die Anzahl der Vielecke
item_list_length = die Länge einer Liste
item_property = eine Eigenschaft
item_list = eine Liste
item_vertex_property = die Eigenschaft { $name } des Elements vertex
item_vertex_coordinate = eine Koordinate einer Ecke
item_face_property = die Eigenschaft vertex_indices des Elements face
item_face_corner = ein Eckpunkt eines Vielecks
item_element_count = die Anzahl der Elemente
item_property_element = das Element einer Eigenschaft
item_format_line = die Zeile format
item_header_end = die Zeile end_header
item_property_name = der Name einer Eigenschaft
item_triangle_count = die Anzahl der Dreiecke
item_triangle_normal = die Normale eines Dreiecks
item_triangle_corner = ein Eckpunkt von Dreieck { $triangle } von { $count }
item_triangle_end = das Ende eines Dreiecks
item_named_coordinate = die Koordinate { $name } einer Ecke
unsupported_version = Version { $version } von glTF
unsupported_separate_file = die getrennte Datei „{ $name }“ (daneben legen oder beide ablegen, .glb verwenden oder einbetten)
unsupported_extension = { $name } (zu entpacken mit: gltf-transform cp in.glb out.glb)
unsupported_encoding = Inhalt, der nicht in Base 64 ist,
unsupported_morphing = Morph-Ziele mit Gewichten (bitte in dem Programm anwenden, aus dem sie sind)
unsupported_dimensions = eine Fläche in 4 oder n Dimensionen ({ $keyword })
fault_no_glb = eine GLB-Datei beginnt mit glTF
fault_no_gltf = kein glTF ({ $message })
fault_node_twice = der Knoten steht zweimal im Baum
fault_mode = unbekannter Modus { $mode }
fault_base64 = kein Base 64: Zeichen { $position } des Inhalts gehört nicht hinein
fault_list_length = eine Liste der Länge { $length }
fault_no_ply = eine PLY-Datei beginnt mit dem Wort ply
fault_unknown_word = unbekanntes Wort { $word }
fault_unknown_format = unbekanntes Format { $format }
fault_no_type = „{ $word }“ ist kein Typ
fault_list_length_type = die Länge einer Liste ist keine ganze Zahl
fault_count = { $what } ist { $found }
fault_accessor_type = { $found } vom Komponententyp { $component }, wo { $needed } nötig war
item_chunk = { $length ->
    [one] ein Block von 1 Byte
   *[other] ein Block von { $length } Byte
}
fault_corner_count = { $count ->
    [one] 1 Eckpunkt ist kein Dreieck
   *[other] { $count } Eckpunkte sind keine ganze Zahl von Dreiecken
}

## conformal

map_point_outside = der Punkt ({ $x }; { $y }) liegt nicht im abgetasteten Umriss ({ $side })
map_anchor_not_finite = der Randpunkt ({ $side }) ist kein endlicher Bruchteil der Bogenlänge
table_too_large = die Tabelle von { $rows }×{ $columns } harmonischen Koordinaten braucht { $megabytes } MB, mehr als die erlaubten { $allowed } MB: etwa { $fitting_samples } Randpunkte passen, oder den adjungierten Kern verwenden, der keine Tabelle braucht
map_no_point = { $triangles ->
    [one] ({ $a }, { $b }, { $c }) in Dreieck { $triangle } ist kein Punkt der Fläche, die 1 Dreieck hat
   *[other] ({ $a }, { $b }, { $c }) in Dreieck { $triangle } ist kein Punkt der Fläche, die { $triangles } Dreiecke hat
}
map_on_boundary = der Punkt der Fläche liegt auf ihrem Rand; er muss innen liegen
map_loop_anchor_not_finite = der Randpunkt der Fläche ist kein endlicher Bruchteil der Länge des Randes
map_other_kind = der Punkt ({ $side }) ist von der anderen Art: ein Ort der Ebene für eine Fläche, oder einer Fläche für einen Umriss
map_no_measure = { $edges ->
    [one] die Enden von 1 Randkante fallen zusammen: Kein innerer Weg führt vom Punkt der Fläche dorthin, oder ein zu langer
   *[other] die Enden von { $edges } Randkanten fallen zusammen: Kein innerer Weg führt vom Punkt der Fläche dorthin, oder ein zu langer
}
map_negative_kernel = { $edges ->
    [one] die Enden von 1 Randkante fallen zusammen: Kein innerer Weg führt vom Punkt der Fläche dorthin, oder ein zu langer, oder der Kern ist dort negativ, wie es ohne intrinsische Delaunay-Kanten sein kann
   *[other] die Enden von { $edges } Randkanten fallen zusammen: Kein innerer Weg führt vom Punkt der Fläche dorthin, oder ein zu langer, oder der Kern ist dort negativ, wie es ohne intrinsische Delaunay-Kanten sein kann
}
walk_start_outside = der Anfang ({ $x }; { $y }) der Irrfahrten liegt nicht im abgetasteten Umriss
walk_no_boundary = nötig ist ein Rand aus mindestens 3 endlichen Punkten, keine zwei Nachbarn gleich
pins_turned = der Umriss wurde gespiegelt, und die Pins liefen anders herum: die Punkte bestimmen die Abbildung
pin_count = { $count } Randpaare sind gegeben: drei bis { $most } bestimmen eine Abbildung
pin_not_finite = Pin { $pin } hat keinen Ort auf dem Rand ({ $side })
pins_coincide = die Pins { $first } und { $second } liegen an derselben Stelle des Randes ({ $side }): jeder braucht eine eigene
pins_out_of_order = die Pins { $first }, { $second } und { $third } laufen um die beiden Ränder in entgegengesetzter Richtung: eine konforme Abbildung erhält ihre Reihenfolge
pins_not_found = kein Punkt ({ $side }) sieht die Bögen zwischen den Pins so wie auf der anderen Seite: zwei Pins liegen vielleicht zu nahe beieinander
pin_missed = die Abbildung verfehlt Pin { $pin } um { $miss }: seine Umgebung hat ein Maß unter der Rundung
map_not_converged = { $side }: { $reason }
map_boundary_integral = { $side }: { $reason }
integral_of_surface = der Integralkern ist für Umrisse: Eine Fläche wird mit finiten Elementen berechnet
stays_few_points = er hat nur { $count } Punkte
stays_many_corners = { $corners } seiner { $count } Punkte sind Ecken
stays_leaves_edge = die glatte Kurve durch seine Punkte würde die Kante bei ({ $x }; { $y }) um mehr als ein Viertel ihrer Länge verlassen
stays_crosses_itself = die glatte Kurve durch seine Punkte würde sich nahe ({ $x }; { $y }) kreuzen
stays_path_crosses = seine Kurven kreuzen sich nahe ({ $x }; { $y })
stays_no_curve = seine Stücke bilden keine Kurve
equation_travels_apart = die Integralgleichung einer Seite wird getrennt von der Seite übertragen
integral_no_curve = die Punkte des Umrisses bilden keine Kurve: Er hat eine Nadel
integral_apart = die Punkte des Umrisses folgen seiner Kurve nicht
integral_not_meshed = Randpunkte auf der Kurve lassen sich nicht vernetzen: { $reason }
integral_too_large = der Rand braucht mindestens { $needed } Unbekannte, mehr als die erlaubten { $limit }: Er hat zu viele Ecken, oder Teile liegen zu nah beieinander
integral_too_much_memory = der Faktor der Randgleichung braucht mehr als { $limit } MB: Zu viele Teile des Randes liegen einander gegenüber
integral_corner_not_resolved = der Rand ist neben seiner Ecke ({ $x }, { $y }) nicht aufgelöst
integral_not_resolved = der Rand lässt sich nicht auflösen: Teile berühren sich, oder ein Stück ist nicht glatt
integral_singular = die Gleichungen des Randes haben keine Lösung: Kreuzt der Rand sich selbst?
integral_not_inside = ({ $x }; { $y }) liegt nicht im Umriss

## rational

formula_of_surface = eine Fläche ({ $side }) hat keine Formel: Eine Formel gibt es nur zwischen zwei Umrissen
formula_finite_elements = keine genauen Randwerte ({ $side }): { $reason }
formula_no_integral = keine genauen Randwerte ({ $side }): Das Randintegral wurde nicht berechnet
formula_no_digit = keine rationale Funktion bis zum Grad { $degree } hat auch nur eine Stelle: Der Fehler der Abbildung ist { $forward }, der ihrer Umkehrung { $inverse }
formula_cancelled = abgebrochen

## zipper

zipper_too_few_points = mindestens 3 Randpunkte sind nötig, nicht { $count }
zipper_not_finite = Randpunkt { $index } ist nicht endlich
zipper_repeated = Randpunkt { $index } wiederholt den vorigen
zipper_point_outside = der Punkt ({ $x }; { $y }) liegt nicht innerhalb der Kurve durch die Randpunkte

## lesson

step_misses_outline = der Link nennt den Umriss „{ $name }“ ({ $side }) nur; er reist als Datei
step_surface_file = die Fläche „{ $name }“ kommt aus einer Datei, die kein Link fasst
step_own_picture = das Muster ist ein eigenes Bild, das kein Link fasst
step_long_caption = der Text hat { $length } Zeichen, höchstens { $limit } sind möglich
lesson_too_large = die Datei ist zu groß für eine Lektion: höchstens { $limit } KiB
lesson_not_text = die Datei ist kein reiner Text (UTF-8)
no_lesson = das ist keine Lektion: Die erste Zeile heißt nicht „riemap lesson { $ours }“
lesson_version = die Lektion hat die Version { $found } eines neueren riemap; dieses öffnet Version { $ours }
lesson_line = Zeile { $line }: Erwartet wird „Title: …“ oder der Link des ersten Schritts, mit #s=… darin
lesson_no_steps = die Lektion hat keinen Schritt: Ein Schritt ist eine Zeile mit einem Link, mit #s=… darin, und darunter sein Text
lesson_too_many_steps = die Lektion hat mehr als { $limit } Schritte
lesson_long_title = der Titel hat { $length } Zeichen, höchstens { $limit } sind möglich
lesson_step = Schritt { $step }: { $error }
lesson_step_at = Schritt { $step } (Zeile { $line }): { $error }
lesson_too_long_for_link = die Lektion ist zu lang für einen Link, der höchstens { $limit } Zeichen hat: als Datei sichern

## session

age_minutes = { $count } min
age_hours = { $count } h
age_days = { $count } T
session_file_damaged = die Datei ist beschädigt: Sie wurde unterwegs abgeschnitten oder verändert ({ $reason })
session_file_part_missing = in der Datei fehlt der Teil „{ $part }“
session_file_part_broken = der Teil „{ $part }“ der Datei ist beschädigt ({ $reason })
session_file_part_too_large = der Teil „{ $part }“ der Datei ist zu groß: höchstens { $limit } MiB
session_file_parts = die Datei hat zu viele Teile: höchstens { $limit }
session_file_in_part = der Teil „{ $part }“ der Datei lässt sich nicht lesen: { $error }
session_file_too_large = die Datei ist zu groß für eine Sitzung: höchstens { $limit } MiB
session_file_malformed = das ist keine Sitzung von riemap, oder die Datei ist beschädigt. Eine andere Datei öffnen, oder den Link der Sitzung ({ $reason })
session_file_no_session = die Datei ist keine Sitzung von riemap: Es steht kein "riemap": { $ours } darin
session_file_version = die Datei hat das Format { $found } eines neueren riemap; dieses liest Format { $ours }
session_file_out_of_range = die Sitzung lässt sich nicht verwenden: { $reason }
session_file_pins = die Pins der Sitzung lassen sich nicht verwenden: { $reason }
session_file_outline = der Umriss der Sitzung ({ $side }) lässt sich nicht verwenden: { $reason }
link_no_session = das ist kein Link zu einer Sitzung: Es steht kein #s=… darin
link_too_long = der Link ist zu lang: { $length } Zeichen, höchstens { $limit } sind möglich
link_version = der Link hat das Format { $found } eines neueren riemap; dieses öffnet Format { $ours }
link_damaged = der Link ist beschädigt: Er wurde unterwegs abgeschnitten oder verändert
link_too_much = der Link enthält mehr, als eine Sitzung sein kann
link_unknown = der Link verlangt „{ $name }“ ({ $what }), was diese Version von riemap nicht kennt
link_out_of_range = der Link lässt sich nicht verwenden: { $reason }
link_pins = die Pins des Links lassen sich nicht verwenden: { $reason }
link_outline = der Umriss des Links ({ $side }) lässt sich nicht verwenden: { $reason }
not_carried_too_long = seine { $points } Punkte brauchen mehr als { $limit } Zeichen
not_carried_not_simple = er ist feiner, als ein Link sagen kann ({ $reason })
not_carried_inexact = er liegt für seine Größe zu weit vom Ursprung
limit_version = die Version der Sitzung
limit_coordinate = eine Koordinate eines inneren Punkts
limit_anchor = die Lage eines Randpunkts
limit_mark = die Lage einer Marke
limit_cells = die Anzahl der Zellen der Textur
limit_picture = die Lage des Bildes
limit_samples = die Anzahl der Randpunkte
limit_growth = das Wachstum der Dreiecke
limit_surface_boundary = die Anzahl der Randecken der Fläche
limit_weight = ein Gewicht des inneren Punkts der Fläche
limit_weight_sum = die Summe der Gewichte des inneren Punkts der Fläche
limit_surface_anchor = die Lage des Randpunkts der Fläche
choice_direction = Richtung
choice_side = Seite
choice_kernel = Kern
choice_solver = Löser
choice_colouring = Färbung
choice_texture = Textur
choice_extension = Fortsetzung
choice_comparison = Vergleich
choice_setting = Einstellung
choice_outline = Umriss
choice_surface = Fläche
out_of_range = { $what } ist { $value }; möglich ist { $low } bis { $high }
outline_shortened = der Umriss „{ $name }“ ({ $side }) hat im Link { $to } seiner { $from } Punkte: Er weicht um höchstens { $deviation } seiner Größe ab
outline_left_out = der Umriss „{ $name }“ ({ $side }) ist nicht im Link: { $reason }. Er reist als Datei

## figures

figure_no_surface = die Figur zeigt keine Fläche
figure_no_domain = die Figur zeigt Umrisse, und eine ihrer Seiten ist eine Fläche
figure_outline = der Umriss einer Szene ist kein einfaches Polygon
settled_disk_kernel_places = x = (0.6, 0.2), y = (1, 0) und m wie in der Bildunterschrift; n folgt aus der Vernetzung von riemap
settled_disk_kernel_phi = φ wird aus dem Ring der Ecken um x interpoliert, nicht linear im Dreieck von x
settled_moebius_constraints = Bedingungen, Gitter und m wie in der Bildunterschrift und in Abschnitt 3.2
settled_moebius_lines = die Linien des Gitters werden Punkt für Punkt abgebildet, 8 Punkte zwischen seinen Knoten
settled_options_outlines = Umrisse: die Hand von riemap; der Klecks des Artikels
settled_both_poles = der Artikel nennt keine Bedingungen: beide Pole der Unzugänglichkeit, beide ersten Randpunkte
settled_q_avg = Q_avg lässt flachgedrückte Dreiecke aus (Q > 10); die Tabelle hat beide Mittel
settled_own_outlines = Umrisse: die von riemap mit diesen Namen
settled_distortion_samples = der Artikel nennt nur das letzte m (3200): m₁ verdoppelt sich ab 400
settled_distortion_constraints = der Artikel zeigt die Bedingungen nur in Figur 1: beide Pole der Unzugänglichkeit, die Spitze des Blatts zu der des ersten Blütenblatts 4 % weiter auf dem Rand, sodass weder Spitze noch Stiel in eine Kerbe kommen
settled_reshaping_samples = 500 Randpunkte des Lebkuchenmanns wie in Tabelle 1; 1000 jedes Ziels
settled_crowding_x1 = x₁ = 0.96 + 0.8432i und y₁ = 1 + i wie in Figur 3
settled_crowding_x2 = der Artikel nennt kein x₂, y₂: die Bilder von 0 und 1 unter der exakten Abbildung des Kleckses
settled_crowding_precomputed = vorberechnete Abbildungen gehen durch die Mitte −i des V und den Pol der Unzugänglichkeit des Kleckses
settled_crowding_zipper = von den anderen Algorithmen des Artikels wird der geodätische (Zipper) gezeigt
settled_l_shapes_hemisphere = die Halbkugel ist die von riemap mit m = 900 wie in der Bildunterschrift; ihre Dreiecke sind gleichmäßig, daher mehr als die 4800 des Artikels
settled_l_shapes_leftmost = ganz links: das L, auf dessen Ecken sechs gleich weit entfernte Punkte gehen, wenn der Pol zu (1, 1)/√3 seiner Seiten geht; nach Schwarz und Christoffel sind seine Arme √3 − 1 davon breit
settled_l_shapes_others = der Artikel nennt weder die anderen Gebiete noch ihre Bedingungen: dasselbe L mit x₁ in einem Arm, dann zwei andere L mit ihren Polen der Unzugänglichkeit; x₂ ist der Pol der Halbkugel (in der App die Ecke, die am weitesten vom Rand liegt), y₁ die einspringende Ecke
settled_head_surface = der Kuhkopf des Artikels gehört nicht zu riemap, dessen eigener Tierkopf steht dafür; --surface DATEI nimmt einen anderen
settled_head_constraints = der Artikel nennt keine Bedingungen: die Ecke, die am weitesten vom Rand liegt, geht zu x₁ = 0, 0.4 und 0.8
settled_head_disk = die Scheibe hat 1000 gleichmäßige Randpunkte
settled_face_surface = das Gesicht des Artikels gehört nicht zu riemap, dessen eigenes Höhenfeld steht dafür; --surface DATEI nimmt ein anderes
settled_face_outlines = Umrisse: die von riemap, mit 1000 gleichmäßigen Randpunkten und ihren Ecken
settled_face_constraints = der Artikel nennt keine Bedingungen: die Nasenspitze (bei einer Datei mit y nach oben die Ecke mit größtem z) geht zum Pol der Unzugänglichkeit, das obere Ende des Randes zum oberen Ende des Umrisses
settled_convergence_constraints = Bedingungen wie in Figur 12
settled_convergence_second_map = mit der exakten zweiten Abbildung bleibt nur der Fehler des V; mit dem Klecks bei m₂ = 1000, wie in Figur 12, begrenzt dessen eigener Fehler das Erreichbare
settled_convergence_zipper = Zipper läuft auf Punkten der exakten Kurve; riemap auf seiner Form, deren Randpunkte mit den nächsten Punkten der Kurve verglichen werden
scene_sixths_to_corners = Sechstel auf Ecken
scene_in_arm = x₁ in einem Arm
scene_narrow_arms = schmale Arme
scene_unequal_arms = ungleiche Arme
scene_v_shape_to_blob = V-Form → Klecks
scene_forward = vorwärts
scene_backward = rückwärts
scene_harmonic = harmonisch

## render

image_data_empty = das Bild hat keine Pixel ({ $width } × { $height })
image_data_byte_count = ein RGBA-Bild von { $width } × { $height } hat { $expected } Byte, dies sind { $actual }
render_no_adapter = kein Grafikadapter gefunden; unter Linux bringt mesa-vulkan-drivers einen aus Software mit ({ $cause })
render_no_device = der Adapter { $adapter } gibt kein Gerät her ({ $cause })
render_size = ein Bild von { $width } × { $height } Pixeln ist nicht möglich: Dieses Gerät zeichnet 1 bis { $limit } je Seite
render_viewport_count = eine Szene braucht 1 bis { $limit } Ansichten, diese hat { $count }
render_image = das Bild der Textur lässt sich nicht verwenden: { $reason }
render_device = das Grafikgerät meldet einen Fehler ({ $reason })
render_readback = die gezeichneten Pixel ließen sich nicht zurücklesen ({ $reason })
film_frames = { $frames ->
    [one] 1 Bild: eine Animation hat 2 bis { $limit }
   *[other] { $frames } Bilder: eine Animation hat 2 bis { $limit }
}
film_rate = { $rate } Bilder je Sekunde: ein GIF hat höchstens 50
film_size = { $width } × { $height } Pixel passen nicht in ein GIF
film_long = { $pictures ->
    [one] die Animation ist nach 1 Bild länger als { $limit } MiB: kleiner oder kürzer machen
   *[other] die Animation ist nach { $pictures } Bildern länger als { $limit } MiB: kleiner oder kürzer machen
}
film_picture = ein Bild von { $width } × { $height } Pixeln unter anderen von anderer Größe
film_encoder = die Animation lässt sich nicht kodieren ({ $reason })
film_seconds = { $seconds } s: eine Animation dauert { $least } bis { $most } s
render_geometry = Ansicht { $viewport }: { $fault }
render_surface = Fläche: { $fault }
too_many_triangles = { $count } Dreiecke passen nicht auf das Grafikgerät
coordinates_differ = { $positions } Orte haben { $coordinates } Texturkoordinaten
codes_differ = { $triangles } Dreiecke haben { $codes } Codes
boundary_too_long = ein Rand von { $boundary } Ecken, wo es { $vertices } gibt
vertex_beyond = Dreieck { $triangle } { $corners } nennt eine Ecke jenseits der { $vertices } gegebenen
device_gone = das Gerät ist nicht mehr da
too_few_bytes = weniger Byte als { $width } × { $height } Pixel
scene_radius = x₁ = { $radius }

## best map

region_holds_nothing = das Gebiet enthält kein Dreieck des Netzes: Es liegt außerhalb des Urbilds oder ist kleiner als ein Dreieck
limit_dabs = die Anzahl der Tupfer im gemalten Gebiet
limit_dab_radius = der Radius eines Tupfers im gemalten Gebiet
no_shared_symmetry = die Umrisse haben keine gemeinsame Symmetrie: nicht je eine Spiegelung und keine Drehung um denselben Winkel

## tiling
tiling_out_of_range = { "{" }{ $sides }, { $around }{ "}" }: Beide Zahlen müssen zwischen { $low } und { $high } liegen
tiling_on_sphere = { "{" }{ $sides }, { $around }{ "}" } lebt auf der Kugel ({ $solid }). Bitte größere Zahlen; das Bild behält sein Parkett
tiling_in_plane = { "{" }{ $sides }, { $around }{ "}" } lebt in der Ebene, wo solche Steine lückenlos passen. Bitte größere Zahlen; das Bild behält sein Parkett

## quadrilaterals
quadrilateral_no_middle = es fand sich kein Punkt, der die Seiten von Marke zu Marke auseinanderhält: das Viereck ist zu schmal, oder zwei Marken liegen zu nah beieinander
mark_not_finite = Marke { $mark } ist kein endlicher Anteil der Randlänge
marks_coincide = Marke { $first } und Marke { $second } sind derselbe Punkt
marks_out_of_order = Marke { $mark } liegt hinter Marke { $next }: die Marken folgen nicht gegen den Uhrzeigersinn aufeinander
quadrilateral_too_long = die Seite von Marke { $a } bis { $b } ist zu weit von der Seite von Marke { $c } bis { $d } entfernt: das Viereck ist mindestens { $length }-mal so lang wie breit, und { $limit } ist die Grenze

## projections
outline_geographic = Längen und Breiten wurden als ebene Koordinaten genommen.
point_of_ring = Punkt { $point } von Ring { $ring }
region_latitude = { $place } hat die Breite { $latitude }°: Breiten gehen von −90° bis 90° (ein Punkt ist [Länge, Breite] in Grad; Meter bitte zuerst umrechnen)
region_longitude = { $place } hat die Länge { $longitude }°: Längen gehen von −180° bis 180° (bis ±360° wird angenommen; Meter bitte zuerst umrechnen)
region_too_few_points = Ring { $ring } hat { $points } verschiedene Punkte hintereinander; ein Ring braucht mindestens 3
region_no_boundary = die Ringe umschließen keine Fläche oder die ganze Kugel
region_nearly_whole_sphere = das Gebiet bedeckt fast die ganze Kugel: kein Punkt liegt mehr als { $clearance }° außerhalb, und { $limit } ist die Grenze
region_crosses = der Rand kreuzt sich bei Länge { $longitude }°, Breite { $latitude }°: die Kante nach { $first } und die Kante nach { $second }
region_touches = der Rand berührt sich bei Länge { $longitude }°, Breite { $latitude }°: die Kante nach { $first } und die Kante nach { $second }
region_no_polygon = der Rand ist unbrauchbar: { $reason }
region_not_meshed = das Gebiet lässt sich nicht triangulieren: { $reason }
projection_cancelled = die Berechnung wurde abgebrochen
projection_is_stereographic = Genommen wurde die beste stereografische Projektion: die an einen festen Maßstab am Rand angepasste Karte schwankt mehr.
