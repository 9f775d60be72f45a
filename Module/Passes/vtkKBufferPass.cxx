#include "vtkKBufferPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkKBufferPass);
