#include "cad/quiet.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Message_PrinterOStream.hxx>

namespace tandem {
inline namespace v0 {
namespace cad {

Quiet::Quiet() {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

Quiet::~Quiet() {
  Message::DefaultMessenger()->AddPrinter(new Message_PrinterOStream());
}

}  // namespace cad
}  // namespace v0
}  // namespace tandem
