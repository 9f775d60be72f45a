// SPDX-FileCopyrightText: Copyright (c) 2026, vtkTranslucency contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSITranslucency
 * @brief   makes a vtkPVTranslucency in a process, and is asked for its statistics
 *
 * The client is asked first, as for all that is there. Where the server has drawn the last frame, it hands the question
 * on.
 *
 * A client without the plugin is told by its server to make one of these, and says that it can't. It then draws by
 * itself; without a class of our own here it would end at once.
 */
#ifndef vtkSITranslucency_h
#define vtkSITranslucency_h

#include "vtkPVTranslucencyViewsModule.h" // for the export macro
#include "vtkSIProxy.h"

class VTKPVTRANSLUCENCYVIEWS_EXPORT vtkSITranslucency : public vtkSIProxy
{
public:
  static vtkSITranslucency* New();
  vtkTypeMacro(vtkSITranslucency, vtkSIProxy);

  void Pull(vtkSMMessage* message) override;

protected:
  vtkSITranslucency() = default;
  ~vtkSITranslucency() override = default;

private:
  vtkSITranslucency(const vtkSITranslucency&) = delete;
  void operator=(const vtkSITranslucency&) = delete;
};

#endif
