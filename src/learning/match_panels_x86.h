#pragma once

#include "learning/match_panels.h"

#if defined(__x86_64__)
namespace place_recognition {

/// Two products of 16-bit numbers a lane and instruction.
MatchPanels matchPanelsAvx2;

/// Four products of 8-bit numbers a lane and instruction.
MatchPanels matchPanelsVnni;

}  // namespace place_recognition
#endif
