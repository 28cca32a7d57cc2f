export const answer = {
  values: [6],
  hints: {
    7: "The meshes have 4 and 3 segments. Their ends are the same vertices, which count once.",
    12: "Only the vertices that one of the meshes already has are used, not all multiples of 1/12.",
    5: "That is the number of vertices between the ends. How many segments do they make?",
    4: "The coarse mesh has vertices at 1/3 and 2/3, which the fine one has not.",
  },
  because:
    "The vertices inside the side are at 1/4, 1/2 and 3/4 and at 1/3 and 2/3. That is five vertices, so there are six segments.",
};
