// The initial scenes, in the order of the buttons. The page contains their files under these names.
const scenes = [
  {
    id: "box", title: "A box in two fingers",
    teaching: "Half a kilogram, pressed with 8 N from each side. Friction 0.5 carries 0.5 · 8 N a side, so 8 N in all. Drag one finger up or down: the two forces then turn the box, and it is held less well or not at all.",
  },
  {
    id: "paper_two_fingers", title: "The paper's two fingers",
    teaching: "The grasp of “Position Control for Multifingered Robot Hand”: springs of 10 N/m, fingers told to go 0.1 m inwards. Both slide at √65/66 N = 0.1222 N, and no equilibrium exists beyond.",
  },
  {
    id: "paper_disk", title: "A disk in three fingers",
    teaching: "A force and a moment at once. Forces share the load by their springs and not by what friction has left: one finger slides while the others hold on, so that onset and limit lie apart.",
  },
  {
    id: "wedge", title: "A wedge in two fingers",
    teaching: "Its flanks lean by 20°. Where friction is below tan 20° = 0.364 the squeeze itself pushes it out, and no squeeze helps. Move friction beyond that.",
  },
  {
    id: "pentagon", title: "A pentagon in four fingers",
    teaching: "With more fingers one after the other gives way as the load grows. Turn the load: some directions are held far better than others.",
  },
  {
    id: "two_parts", title: "Two parts in two fingers",
    teaching: "The right part hangs on a finger and on the left part: 0.5 · 8 N each. What one part does to the other the other does to it, so each joint has two arrows. Drag the left finger down: the left part turns, and the joint opens at one end.",
  },
];
