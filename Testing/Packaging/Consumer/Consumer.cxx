#include <vtkAdaptiveTransparencyPass.h>
#include <vtkNew.h>

#include <iostream>

int main()
{
  vtkNew<vtkAdaptiveTransparencyPass> pass;
  pass->SetNodeCount(8);
  std::cout << pass->GetClassName() << " with " << pass->GetNodeCount() << " nodes\n";
  return 0;
}
