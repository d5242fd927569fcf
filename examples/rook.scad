// A rook and a pawn on four squares of a chess board. examples/rook.csg is its export:
//     openscad rook.scad -o rook.csg

square_size = 30;
merlons = 6;
$fn = 64;

module ring(height, outer, inner) {
  difference() {
    cylinder(h = height, r = outer);
    translate([0, 0, -1]) cylinder(h = height + 2, r = inner);
  }
}

module foot() {
  cylinder(h = 3, r = 11);
  translate([0, 0, 3]) cylinder(h = 3, r1 = 11, r2 = 8.5);
  translate([0, 0, 6]) cylinder(h = 1.5, r = 9);
}

module rook() {
  foot();
  translate([0, 0, 7]) cylinder(h = 19, r1 = 8, r2 = 5.8);
  translate([0, 0, 26]) cylinder(h = 2, r1 = 5.8, r2 = 8.2);
  translate([0, 0, 28]) difference() {
    ring(8, 8.2, 5);
    for (i = [0 : merlons - 1]) rotate(i * 360 / merlons) translate([0, -1.3, 4]) cube([10, 2.6, 5]);
  }
  translate([0, 0, 27]) cylinder(h = 3, r = 6);
}

module pawn() {
  foot();
  difference() {
    translate([0, 0, 7]) cylinder(h = 15, r1 = 7.5, r2 = 3.4);
    for (i = [0 : 7]) rotate(i * 45) translate([8.1, 0, 7]) scale([1, 1, 4]) sphere(r = 2.4);
  }
  translate([0, 0, 21]) cylinder(h = 1.6, r = 5.6);
  translate([0, 0, 26.5]) sphere(r = 5.4);
}

module board() {
  for (x = [-1 : 1], y = [-1 : 1])
    color((x + y) % 2 == 0 ? "#6b4226" : "#e8c890")
      translate([x * square_size, y * square_size, -4]) cube([square_size, square_size, 4]);
}

board();
color("ivory") translate([square_size / 2, square_size / 2, 0]) rook();
color("#3a2a22") translate([-square_size / 2, square_size / 2, 0]) rook();
color("ivory") translate([-square_size / 2, -square_size / 2, 0]) pawn();
color("#3a2a22") translate([square_size * 3 / 2, square_size * 3 / 2, 0]) pawn();
