// SPDX-License-Identifier: Apache-2.0
// Which part of a cell along a wall a place is in, for C++ and GLSL, from the words that welkin_volume_cuts gives. C++
// includes this file in a struct, with doors.glsl before it. The includer has:
//   CutWords                 two words: x, y
//   CutWords cutWords(int i) the i-th two of the words
//   uint cutWord(int i)      the i-th word
//   Number cutFloat(uint w)  the float with these bits
//   int cutMask(int axis)    sectors of the table along x (0) and z (1), less 1; a power of two less 1
// The words are a table of sectors, one word each, then a block for each: nodes of two words. The first 4,096 are its cells,
// in the order of the grid; the others are the trees below these.
//   sector  bits 0-7: 1 more than its block, 0 if it has none; 8-15: height of its cells; 16-31: its bottom, plus 32,768;
//           both in units of 4 m
//   leaf    y is 0. x is 0 where the volume's own texels serve, else a brick: bit 30; bits 0-10, 11-18 and 19-26 are where it
//           lies along z, y and x, in bricks
//   plane   x: the normal's x and z, 16 bits each, over 32,767. y: bit 31; bit 30 if the normal points down; bits 0-17: the
//           offset from the cell's low corner plus 131,072, in 131,072ths of the cell's longest edge; bits 18-28: the node
//           below, after which the one above follows, counted from the first after the cells
//   doors   as a plane, with bit 29 of y. It has one tree below it. x, bits 0-15: the first of the nodes of its doors; bits
//           16-31: their number. A door has six nodes: its low corner, and the axis of its face's normal, plus 4 if the
//           normal points out of the room; its high corner, the face; x and z between which it fades: low and high of x,
//           low and high of z. These are from the cell's low corner, and the face is where a plane of the tree has it, so
//           that both agree on a place's side

// A place in a brick, in texels from its corner. `brick` is 0 where the volume's own texels serve.
struct CutBrick {
  uint brick;
  Number3 at;
  Number3 corner;  // low corner of the place's cell
  int door;   // node of the cell's first door
  int doors;  // of the cell
};

// A place beyond a door's face, and the one from where a surface there looks up its light. `share` of the light of a place
// in the door is that of the other.
struct CutDoor {
  Number share;
  Number3 p;
  Number3 place;
};

INLINE Number cutSize(Number v) { return max(v, -v); }

// Where a brick lies, in bricks.
INLINE Number3 cutBrickCorner(uint brick) {
  return Number3(Number((brick >> 19) & 0xffu), Number((brick >> 11) & 0xffu), Number(brick & 0x7ffu));
}

// The brick that lights a surface at p, and in it the place from where the surface looks up its light.
INLINE CutBrick cutBrickAt(Number3 p, Number3 place) {
  int x = int(floor(p.x * NUMBER(0.25)));
  int z = int(floor(p.z * NUMBER(0.25)));
  int sectors = (cutMask(0) + 1) * (cutMask(1) + 1);
  uint sector = cutWord(((x >> 4) & cutMask(0)) + (cutMask(0) + 1) * ((z >> 4) & cutMask(1)));
  Number low_y = NUMBER(4.0) * Number(int(sector >> 16) - 32768);
  Number height_m = max(NUMBER(4.0) * Number((sector >> 8) & 0xffu), NUMBER(4.0));
  Number y = (p.y - low_y) / height_m;
  bool is_there = (sector & 0xffu) != 0u && y >= NUMBER(0.0) && y < NUMBER(16.0);
  int row = is_there ? int(y) : 0;
  int cells = sectors / 2 + (int(sector & 0xffu) - 1) * CUT_BLOCK_NODES;
  Number3 corner = Number3(NUMBER(4.0) * Number(x), low_y + height_m * Number(row), NUMBER(4.0) * Number(z));
  Number3 from = p - corner;
  Number step_m = height_m * NUMBER(0.00000762939453125);
  int at = is_there ? cells + (x & 15) + 16 * (row + 16 * (z & 15)) : 0;
  CutBrick found;
  found.brick = 0u;
  found.door = 0;
  found.doors = 0;
  bool is_leaf = false;
  do {
    CutWords node = cutWords(at);
    is_leaf = !is_there || (node.y & 0x80000000u) == 0u;
    if ((node.y & 0x20000000u) != 0u && is_there) {
      found.door = cells + 4096 + int(node.x & 0xffffu);
      found.doors = int(node.x >> 16);
    }
    Number normal_x = Number(int(node.x << 16) >> 16) * NUMBER(0.000030518509475997192);
    Number normal_z = Number(int(node.x) >> 16) * NUMBER(0.000030518509475997192);
    Number up = NUMBER(1.0) - cutSize(normal_x) - cutSize(normal_z);
    Number offset = Number(int(node.y & 0x3ffffu) - 131072) * step_m;
    Number rise = normal_x * from.x + ((node.y & 0x40000000u) != 0u ? -up : up) * from.y + normal_z * from.z;
    at = cells + 4096 + int((node.y >> 18) & 0x7ffu) + (rise > offset ? 1 : 0);
    if (is_leaf && is_there) found.brick = node.x;
  } while (!is_leaf);
  found.corner = corner;
  found.at = Number3((place.x - corner.x) * NUMBER(0.25), (place.y - corner.y) / height_m,
                     (place.z - corner.z) * NUMBER(0.25)) + Number3(NUMBER(1.0));
  return found;
}

// The place beyond the face of the first door that has a share at p, which is the place of `found`.
INLINE CutDoor cutDoorOf(CutBrick found, Number3 p, Number3 place) {
  Number3 from = p - found.corner;
  CutDoor beyond;
  beyond.share = NUMBER(0.0);
  beyond.p = p;
  beyond.place = place;
  for (int i = found.door; i < found.door + 6 * found.doors && beyond.share <= NUMBER(0.0); i += 6) {
    CutWords low = cutWords(i);
    CutWords low_end = cutWords(i + 1);
    CutWords high = cutWords(i + 2);
    CutWords high_end = cutWords(i + 3);
    CutWords fade_x = cutWords(i + 4);
    CutWords fade_z = cutWords(i + 5);
    Number3 at_least = Number3(cutFloat(low.x), cutFloat(low.y), cutFloat(low_end.x));
    Number3 at_most = Number3(cutFloat(high.x), cutFloat(high.y), cutFloat(high_end.x));
    Number3 size = at_most - at_least;
    if (from.x < at_least.x || from.y < at_least.y || from.z < at_least.z || from.x > at_most.x || from.y > at_most.y ||
        from.z > at_most.z)
      continue;
    int axis = int(low_end.y & 3u);
    Number outwards = (low_end.y & 4u) != 0u ? NUMBER(1.0) : NUMBER(-1.0);
    Number face = cutFloat(high_end.y);
    Number along = axis == 0 ? from.x : axis == 1 ? from.y : from.z;
    Number first = axis == 0 ? at_least.x : axis == 1 ? at_least.y : at_least.z;
    Number last = axis == 0 ? at_most.x : axis == 1 ? at_most.y : at_most.z;
    beyond.share = doorThrough(along, face, outwards > NUMBER(0.0) ? first : last, outwards > NUMBER(0.0) ? last : first) *
                   doorFade(from.x, cutFloat(fade_x.x), cutFloat(fade_x.y), NUMBER(0.25) * size.x) *
                   doorFade(from.z, cutFloat(fade_z.x), cutFloat(fade_z.y), NUMBER(0.25) * size.z);
    // To the other side of the face, if they are not there. A place stays on its side of the face's plane by 1/256 m.
    Number side = (along - face) * outwards > NUMBER(0.0) ? -outwards : outwards;
    Number there = face + side * NUMBER(0.00390625);
    if (axis == 0) {
      beyond.p.x = found.corner.x + there;
      beyond.place.x = side > NUMBER(0.0) ? max(place.x, beyond.p.x) : min(place.x, beyond.p.x);
    } else if (axis == 1) {
      beyond.p.y = found.corner.y + there;
      beyond.place.y = side > NUMBER(0.0) ? max(place.y, beyond.p.y) : min(place.y, beyond.p.y);
    } else {
      beyond.p.z = found.corner.z + there;
      beyond.place.z = side > NUMBER(0.0) ? max(place.z, beyond.p.z) : min(place.z, beyond.p.z);
    }
  }
  return beyond;
}
