// SPDX-License-Identifier: Apache-2.0
// The transfer basis of Deferred Radiance Transfer Volumes (Stefanov, GDC 2012) and the weights that shade with it.

// Three orthonormal directions that point up, and one that points down.
struct TransferBasis {
  Number3 v[4];
};

INLINE TransferBasis transferBasis() {
  Number up = sqrt(NUMBER(1.0) / NUMBER(3.0));
  Number side = sqrt(NUMBER(0.5));
  Number back = -sqrt(NUMBER(1.0) / NUMBER(6.0));
  TransferBasis basis;
  basis.v[0] = Number3(sqrt(NUMBER(2.0) / NUMBER(3.0)), up, NUMBER(0.0));
  basis.v[1] = Number3(back, up, side);
  basis.v[2] = Number3(back, up, -side);
  basis.v[3] = Number3(NUMBER(0.0), NUMBER(-1.0), NUMBER(0.0));
  return basis;
}

struct TransferWeights {
  Number v[4];
};

// Weight of each direction's irradiance for a unit normal. The weights sum to 1 and are exact for every irradiance that
// is linear in the normal.
INLINE TransferWeights transferWeights(Number3 normal) {
  TransferBasis basis = transferBasis();
  TransferWeights weight;
  weight.v[0] = dot(normal, basis.v[0]);
  weight.v[1] = dot(normal, basis.v[1]);
  weight.v[2] = dot(normal, basis.v[2]);
  Number rest = NUMBER(1.0) - (weight.v[0] + weight.v[1] + weight.v[2]);
  Number root = sqrt(NUMBER(3.0));
  Number each = rest / (root * (NUMBER(1.0) + root));
  weight.v[0] += each;
  weight.v[1] += each;
  weight.v[2] += each;
  weight.v[3] = rest / (NUMBER(1.0) + root);
  return weight;
}
