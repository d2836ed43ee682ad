// The session's printing. Sheets are drawn anew, since those on the screen have coarser pictures.
#include "core/base/counted.h"
#include "core/base/error.h"
#include "core/project/session_impl.h"
#include "core/sheet/write.h"

namespace netwright {

void Session::print(const PrintJob& job) {
  if (!sheets()) return;
  auto chore = std::make_shared<Impl::Chore<Message>>(impl_->bell);
  const auto work = [chore, job, source = project(), now = impl_->derived](Progress& progress) {
    progress.set_phase("Printing");
    auto news = std::make_shared<Message>();
    try {
      const std::vector<Sheet> chosen = printed_sheets(job, source, *now);
      const std::string& title = source.source->name;
      send_to_printer(printing_program("lp", printing_folders()), job, pdf_bytes(chosen, title), title,
                      progress);
      *news = {Message::Kind::Good,
               counted(static_cast<std::int64_t>(chosen.size()), "sheet", "sheets") + " sent to " +
                   (job.printer.empty() ? "the printer" : job.printer) + ".",
               0};
    } catch (...) {
      *news = {Message::Kind::Error, sentence_for_current_exception("Printing"), 0};
    }
    chore->result.post(std::move(news));
  };
  chore->progress = impl_->worker.submit(Worker::Lane::Chores, work);
  impl_->exports.push_back(std::move(chore));
}

void Session::look_for_printers() {
  if (impl_->searching_printers) return;
  auto chore = std::make_shared<Impl::Chore<std::vector<std::string>>>(impl_->bell);
  chore->progress = impl_->worker.submit(Worker::Lane::Chores, [chore](Progress&) {
    auto found = std::make_shared<std::vector<std::string>>();
    try {
      *found = find_printers(printing_program("lpstat", printing_folders()));
    } catch (const Error&) {
      found->clear();  // a system that cannot be asked has no printers
    }
    chore->result.post(std::move(found));
  });
  impl_->searching_printers = std::move(chore);
}

const std::vector<std::string>* Session::printers() const { return impl_->printers.get(); }

bool Session::Impl::take_printers() {
  const auto found = searching_printers ? searching_printers->result.take() : nullptr;
  if (!found) return false;
  printers = found;
  searching_printers = nullptr;
  return true;
}

}  // namespace netwright
