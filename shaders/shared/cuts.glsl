// SPDX-License-Identifier: Apache-2.0
// Which part of a cell along a wall a place is in, for C++ and GLSL, from the words that welkin_volume_cuts gives. C++
// includes this file in a struct, with doors.glsl before it. The includer has:
//   CutWords                 four words: x, y, z, w
//   CutWords cutWords(int i) the i-th four of the words
//   uint cutWord(int i)      the i-th word
//   Number cutFloat(uint w)  the float with these bits
//   int cutMask(int axis)    sectors of the table along x (0) and z (1), less 1; a power of two less 1
// The words are a table of sectors, one word each, then a block for each: its 4,096 cells, one word each, and the nodes of
// their trees, four words each. Nothing here reads beyond what the table leads to.
//   sector  bits 0-7: 1 more than its block, 0 if it has none; 8-15: height of its cells; 16-31: its bottom, plus 32,768;
//           both in units of 4 m
//   cell    0: the volume's own texels serve it; bit 31: bits 0-15 are the first node of its tree, bits 16-20 the number of
//           its doors, whose nodes, three each, are before the tree; else a brick
//   brick   bit 30; bits 0-10, 11-18 and 19-26: where it lies along z, y and x, in bricks
//   node    a plane: its normal's x and z, its offset, how far the node above it is, and bit 8 if the normal points down;
//           or a brick, 0, 0, 0
//   door    its low corner, and the axis of its face's normal, plus 4 if the normal points out of the room; its high
//           corner, the face; x and z between which it fades: low and high of x, low and high of z
// Places of doors are from the corner of the sector, y of the world.

// A place in a brick, in texels from its corner. `brick` is 0 where the volume's own texels serve.
struct CutBrick {
  uint brick;
  Number3 at;
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

// How far a place is above a node's plane. Metres from the corner of the sector, y of the world.
INLINE Number cutAbove(CutWords node, Number3 p) {
  Number x = cutFloat(node.x);
  Number z = cutFloat(node.y);
  Number y = NUMBER(1.0) - cutSize(x) - cutSize(z);
  return x * p.x + ((node.w & 0x100u) != 0u ? -y : y) * p.y + z * p.z - cutFloat(node.z);
}

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
  Number height_m = NUMBER(4.0) * Number((sector >> 8) & 0xffu);
  Number y = (p.y - low_y) / max(height_m, NUMBER(4.0));
  bool is_there = (sector & 0xffu) != 0u && y >= NUMBER(0.0) && y < NUMBER(16.0);
  int row = is_there ? int(y) : 0;
  int block = sectors + (int(sector & 0xffu) - 1) * CUT_BLOCK_WORDS;
  uint word = is_there ? cutWord(block + (x & 15) + 16 * (row + 16 * (z & 15))) : 0u;
  CutBrick found;
  found.door = 0;
  found.doors = 0;
  if ((word & 0x80000000u) != 0u) {
    Number3 from = Number3(p.x - NUMBER(64.0) * Number(x >> 4), p.y, p.z - NUMBER(64.0) * Number(z >> 4));
    found.door = (block + 4096) / 4 + int(word & 0xffffu);
    found.doors = int((word >> 16) & 31u);
    int at = found.door + 3 * found.doors;
    while ((word & 0x80000000u) != 0u) {
      CutWords node = cutWords(at);
      if (node.w == 0u) word = node.x;
      at += cutAbove(node, from) > NUMBER(0.0) ? int(node.w & 0xffu) : 1;
    }
  }
  found.brick = word;
  found.at = Number3(place.x * NUMBER(0.25) - Number(x), (place.y - low_y) / max(height_m, NUMBER(4.0)) - Number(row),
                     place.z * NUMBER(0.25) - Number(z)) + Number3(NUMBER(1.0));
  return found;
}

// The place beyond the face of the first door that has a share at p, which is the place of `found`.
INLINE CutDoor cutDoorOf(CutBrick found, Number3 p, Number3 place) {
  Number corner_x = NUMBER(64.0) * floor(p.x * NUMBER(0.015625));
  Number corner_z = NUMBER(64.0) * floor(p.z * NUMBER(0.015625));
  CutDoor beyond;
  beyond.share = NUMBER(0.0);
  beyond.p = p;
  beyond.place = place;
  for (int i = found.door; i < found.door + 3 * found.doors && beyond.share <= NUMBER(0.0); i += 3) {
    CutWords low = cutWords(i);
    CutWords high = cutWords(i + 1);
    CutWords fade = cutWords(i + 2);
    Number3 from = Number3(p.x - corner_x, p.y, p.z - corner_z);
    Number3 at_least = Number3(cutFloat(low.x), cutFloat(low.y), cutFloat(low.z));
    Number3 at_most = Number3(cutFloat(high.x), cutFloat(high.y), cutFloat(high.z));
    Number3 size = at_most - at_least;
    if (from.x < at_least.x || from.y < at_least.y || from.z < at_least.z || from.x > at_most.x || from.y > at_most.y ||
        from.z > at_most.z)
      continue;
    int axis = int(low.w & 3u);
    Number outwards = (low.w & 4u) != 0u ? NUMBER(1.0) : NUMBER(-1.0);
    Number face = cutFloat(high.w);
    Number along = axis == 0 ? from.x : axis == 1 ? from.y : from.z;
    Number first = axis == 0 ? at_least.x : axis == 1 ? at_least.y : at_least.z;
    Number last = axis == 0 ? at_most.x : axis == 1 ? at_most.y : at_most.z;
    beyond.share = doorThrough(along, face, outwards > NUMBER(0.0) ? first : last, outwards > NUMBER(0.0) ? last : first) *
                   doorFade(from.x, cutFloat(fade.x), cutFloat(fade.y), NUMBER(0.25) * size.x) *
                   doorFade(from.z, cutFloat(fade.z), cutFloat(fade.w), NUMBER(0.25) * size.z);
    // To the other side of the face, if they are not there. A place stays on its side of the face's plane by 1/256 m.
    Number side = (along - face) * outwards > NUMBER(0.0) ? -outwards : outwards;
    Number there = face + side * NUMBER(0.00390625);
    if (axis == 0) {
      beyond.p.x = corner_x + there;
      beyond.place.x = side > NUMBER(0.0) ? max(place.x, beyond.p.x) : min(place.x, beyond.p.x);
    } else if (axis == 1) {
      beyond.p.y = there;
      beyond.place.y = side > NUMBER(0.0) ? max(place.y, beyond.p.y) : min(place.y, beyond.p.y);
    } else {
      beyond.p.z = corner_z + there;
      beyond.place.z = side > NUMBER(0.0) ? max(place.z, beyond.p.z) : min(place.z, beyond.p.z);
    }
  }
  return beyond;
}
