// place_labeler: a person says which room it is; records a labelled run. See launch/record.launch.

#include "ros/place_labeler.h"

#include "ros/labeler_main.h"

int main(int argc, char** argv) {
  return place_recognition::runLabeler<place_recognition::PlaceLabeler>(argc, argv,
                                                                        "place_labeler");
}
