#include "cad/read.h"
#include "cad/write.h"
#include "io/cad_component.h"
#include "tandem/version.h"

#define TANDEM_CAD_EXPORT __attribute__((visibility("default")))

extern "C" {

TANDEM_CAD_EXPORT const char* tandem_cad_version() {
  return tandem::kVersion.data();
}

TANDEM_CAD_EXPORT const tandem::CadComponent* tandem_cad_component() {
  static const tandem::CadComponent component{tandem::cad::read_curves, tandem::cad::format};
  return &component;
}

}  // extern "C"
