/* Two palms press with 10 N each on a box, friction 0.5, and hold 6 N: each carries 3 N of at most 5 N. */
#include "../grasp_lcp.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int wrong(const char *what) {
    fprintf(stderr, "%s\n", what);
    return 1;
}

int main(void) {
    grasp_lcp_finger_t palms[2] = {
        {.point = {.x = -1.0}, .normal = {.x = 1.0}},
        {.point = {.x = 1.0}, .normal = {.x = -1.0}},
    };
    for (int i = 0; i < 2; i++) {
        palms[i].normal_stiffness = 1e3;
        palms[i].tangential_stiffness = 8e2;
        palms[i].friction = 0.5;
        palms[i].press = 10.0;
    }
    slice_ref_grasp_lcp_finger_t both = {palms, 2};
    grasp_lcp_fingers_t *fingers = NULL;
    if (grasp_lcp_fingers(both, &fingers) != NULL || fingers == NULL) return wrong("the palms are as they should be");

    grasp_lcp_vector_t forces[2] = {{10.0, 3.0, 0.0}, {-10.0, 3.0, 0.0}};
    slice_ref_grasp_lcp_vector_t measured = {forces, 2};
    grasp_lcp_load_t to_come = {.force = {.y = -5.0}};
    grasp_lcp_watched_t seen;
    if (grasp_lcp_watch(fingers, measured, &to_come, &seen) != NULL) return wrong("the forces are as they should be");
    /* Of a further load of 5 N they hold four fifths; for the whole load each must press with 11 N. */
    if (fabs(seen.margin - 2.0) > 1e-12) return wrong("margin");
    if (fabs(seen.first_slip - 0.8) > 1e-12) return wrong("first slip");
    if (fabs(seen.extra_squeeze - 0.1) > 1e-12) return wrong("extra squeeze");

    measured.len = 1;
    char *text = grasp_lcp_watch(fingers, measured, &to_come, &seen);
    if (text == NULL || strcmp(text, "forces: 1 given, must be 2, one a finger") != 0) return wrong("one force for two fingers");
    grasp_lcp_text_free(text);
    grasp_lcp_fingers_free(fingers);

    palms[1].friction = -1.0;
    text = grasp_lcp_fingers(both, &fingers);
    if (text == NULL || fingers != NULL || strstr(text, "contact 1: friction coefficient is -1") == NULL) return wrong("friction below zero");
    grasp_lcp_text_free(text);
    both.len = 1;
    text = grasp_lcp_fingers(both, &fingers);
    if (text == NULL || strcmp(text, "fingers: 1 given, must be from 2 to 5") != 0) return wrong("one finger");
    grasp_lcp_text_free(text);
    grasp_lcp_text_free(NULL);
    grasp_lcp_fingers_free(NULL);
    return 0;
}
